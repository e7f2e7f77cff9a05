#pragma once
/// Pillars made of a contour, and the parameters that they share.
#include <cmath>
#include <numbers>

#include "geometry/contour.hpp"

namespace dld {

class ContourPillar : public PillarShape {
 public:
  /// Corners in counter-clockwise order; see Contour for the rounding.
  ContourPillar(const std::vector<Point2>& corners, double corner_radius)
      : contour_(corners, corner_radius) {}
  double signed_distance(double x, double y) const override { return contour_.signed_distance(x, y); }
  double bounding_radius() const override { return contour_.bounding_radius(); }
  double area() const override { return contour_.area(); }
  std::vector<Point2> outline() const override { return contour_.outline(); }

 private:
  Contour contour_;
};

inline PillarParameter corner_radius_parameter() {
  return {.name = "corner_radius_um",
          .fallback = 0,
          .minimum = 0,
          .maximum = 1000,
          .unit = "um",
          .doc = "radius by which corners that point out are rounded, inside the sharp outline"};
}

inline PillarParameter rotation_parameter() {
  return {.name = "rotation_deg",
          .fallback = 0,
          .minimum = -360,
          .maximum = 360,
          .unit = "degrees",
          .doc = "rotation about the centre, counter-clockwise"};
}

/// Turns points about the origin, counter-clockwise (degrees). Multiples of 90 degrees are exact.
inline std::vector<Point2> rotated(std::vector<Point2> points, double degrees) {
  const double quarters = degrees / 90, angle = degrees * std::numbers::pi / 180;
  double c = std::cos(angle), s = std::sin(angle);
  if (quarters == std::round(quarters)) c = std::round(c), s = std::round(s);
  for (Point2& p : points) p = {c * p[0] - s * p[1], s * p[0] + c * p[1]};
  return points;
}

}  // namespace dld
