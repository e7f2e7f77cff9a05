#pragma once
/// Pillar shapes behind one signed-distance interface. A new shape is one file with a class and one
/// line in the registry (pillar.cpp); nothing outside the file of a shape may assume what it looks like.
#include <memory>
#include <string>
#include <vector>

namespace dld {

/// What a case says about a pillar, in the length unit of the caller (lattice units in the solver).
struct PillarSize {
  double radius = 0.0;  ///< R: circumscribed radius of the shape
};

/// Cross-section of one pillar centred at the origin (pillars are prisms along z).
class PillarShape {
 public:
  virtual ~PillarShape() = default;
  /// Distance from (x, y) to the surface, negative inside; exact near the surface.
  virtual double signed_distance(double x, double y) const = 0;
  /// Radius of a circle about the origin that holds the shape; negative if there is no pillar at all.
  virtual double bounding_radius() const = 0;
};

/// The shape registered as `name`; throws std::invalid_argument for an unknown name.
std::unique_ptr<PillarShape> make_pillar(const std::string& name, const PillarSize& size);

/// Registered names, in the order of the registry.
std::vector<std::string> pillar_shape_names();

}  // namespace dld
