#pragma once
/// Circular pillar (Krueger et al. 2014, and most devices in use).
#include <cmath>
#include <numbers>

#include "geometry/pillar.hpp"

namespace dld {

class Circle final : public PillarShape {
 public:
  static constexpr const char* doc = "a circle";
  static std::vector<PillarParameter> parameters() {
    return {{.name = "radius_um",
             .example = {10},
             .minimum = 0,
             .maximum = 1000,
             .open_minimum = true,
             .unit = "um",
             .doc = "R, radius"}};
  }
  static std::vector<PillarProblem> problems(const PillarValues&) { return {}; }
  static Circle from(const PillarValues& values) { return Circle(values.number("radius_um")); }

  explicit Circle(double radius) : radius_(radius) {}
  double signed_distance(double x, double y) const override { return std::sqrt(x * x + y * y) - radius_; }
  double bounding_radius() const override { return radius_; }
  double area() const override { return std::numbers::pi * radius_ * radius_; }
  double gap(double dx, double dy) const override { return std::hypot(dx, dy) - 2 * radius_; }
  std::vector<Point2> outline() const override {
    constexpr int n = 72;  // curve_step
    std::vector<Point2> points;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n;
      points.push_back({radius_ * std::cos(angle), radius_ * std::sin(angle)});
    }
    return points;
  }

 private:
  double radius_;
};

}  // namespace dld
