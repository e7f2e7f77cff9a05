#pragma once
/// Elliptic pillar.
#include "geometry/pillar.hpp"

namespace dld {

class Ellipse final : public PillarShape {
 public:
  static constexpr const char* doc = "an ellipse";
  static std::vector<PillarParameter> parameters();
  static std::vector<PillarProblem> problems(const PillarValues&) { return {}; }
  static Ellipse from(const PillarValues& values);

  /// Semi-axes a and b along x and y before the turn by `rotation` (rad, counter-clockwise).
  Ellipse(double a, double b, double rotation);
  double signed_distance(double x, double y) const override;
  double bounding_radius() const override;
  double area() const override;
  std::vector<Point2> outline() const override;

 private:
  double a_, b_, cos_, sin_;
};

}  // namespace dld
