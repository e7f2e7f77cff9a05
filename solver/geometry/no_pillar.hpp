#pragma once
/// An empty slit: the unit cell without a pillar, for validation and for the optical tweezer.
#include <cmath>
#include <limits>

#include "geometry/pillar.hpp"

namespace dld {

class NoPillar final : public PillarShape {
 public:
  static constexpr const char* doc = "an empty slit";
  static std::vector<PillarParameter> parameters() {
    return {{.name = "radius_um",
             .fallback = 0,
             .minimum = 0,
             .maximum = 1000,
             .unit = "um",
             .doc = "R of the gap G = pitch - 2 R by which the length scale l = sqrt(G H) is meant"}};
  }
  static std::vector<PillarProblem> problems(const PillarValues&) { return {}; }
  static NoPillar from(const PillarValues& values) { return NoPillar(values.number("radius_um")); }

  /// reference_radius: R of the array with which the slit is compared.
  explicit NoPillar(double reference_radius = 0) : reference_radius_(reference_radius) {}
  double signed_distance(double, double) const override { return std::numeric_limits<double>::max(); }
  double bounding_radius() const override { return -1.0; }
  double area() const override { return 0; }
  double gap(double dx, double dy) const override { return std::hypot(dx, dy) - 2 * reference_radius_; }
  std::vector<Point2> outline() const override { return {}; }

 private:
  double reference_radius_;
};

}  // namespace dld
