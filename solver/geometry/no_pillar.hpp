#pragma once
/// An empty slit: the unit cell without a pillar, for validation and for the optical tweezer.
#include <limits>

#include "geometry/pillar.hpp"

namespace dld {

class NoPillar final : public PillarShape {
 public:
  explicit NoPillar(const PillarSize&) {}
  double signed_distance(double, double) const override { return std::numeric_limits<double>::max(); }
  double bounding_radius() const override { return -1.0; }
};

}  // namespace dld
