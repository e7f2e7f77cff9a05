#pragma once
/// Pillars made of a contour, and the parameters that they share.
#include <cmath>
#include <numbers>

#include "geometry/contour.hpp"
#include "geometry/text.hpp"

namespace dld {

class ContourPillar : public PillarShape {
 public:
  /// Corners in counter-clockwise order; see Contour for the rounding, by one radius or by one for each
  /// corner.
  ContourPillar(const std::vector<Point2>& corners, double corner_radius)
      : ContourPillar(corners, std::vector<double>(corners.size(), corner_radius)) {}
  ContourPillar(const std::vector<Point2>& corners, const std::vector<double>& radii)
      : contour_(corners, radii) {}
  double signed_distance(double x, double y) const override { return contour_.signed_distance(x, y); }
  double bounding_radius() const override { return contour_.bounding_radius(); }
  double area() const override { return contour_.area(); }
  std::vector<Point2> outline() const override { return contour_.outline(); }

 private:
  Contour contour_;
};

/// A length without default, um; the texts outlive the program's tables.
inline PillarParameter length_parameter(const char* name, double example, const char* doc) {
  return {.name = name,
          .example = {example},
          .minimum = 0,
          .maximum = 1000,
          .open_minimum = true,
          .unit = "um",
          .doc = doc};
}

/// Adds a problem if the length of that name is not less than `limit`, which is `what`.
inline void require_less(const PillarValues& values, const char* name, double limit, const std::string& what,
                         std::vector<PillarProblem>& problems) {
  if (values.number(name) < limit) return;
  problems.push_back({name, number_text(values.number(name)),
                      "less than " + what + " of " + number_text(limit) + " um",
                      "use e.g. " + number_text(limit / 2)});
}

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
