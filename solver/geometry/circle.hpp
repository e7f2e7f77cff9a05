#pragma once
/// Circular pillar (Krueger et al. 2014, and most devices in use).
#include <cmath>

#include "geometry/pillar.hpp"

namespace dld {

class Circle final : public PillarShape {
 public:
  explicit Circle(const PillarSize& size) : radius_(size.radius) {}
  double signed_distance(double x, double y) const override { return std::sqrt(x * x + y * y) - radius_; }
  double bounding_radius() const override { return radius_; }

 private:
  double radius_;
};

}  // namespace dld
