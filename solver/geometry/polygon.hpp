#pragma once
/// Regular polygon: triangle, diamond, square, hexagon and so on.
#include "geometry/contour_pillar.hpp"

namespace dld {

class Polygon final : public ContourPillar {
 public:
  static constexpr const char* doc = "a regular polygon; rotation 0 has one corner towards +y";
  static std::vector<PillarParameter> parameters() {
    return {{.name = "sides",
             .kind = PillarParameter::Kind::whole,
             .example = {3},
             .minimum = 3,
             .maximum = 60,
             .doc = "number of sides"},
            {.name = "circumradius_um",
             .example = {11},
             .minimum = 0,
             .maximum = 1000,
             .open_minimum = true,
             .unit = "um",
             .doc = "radius of the circle through the sharp corners"},
            rotation_parameter(),
            corner_radius_parameter()};
  }
  static std::vector<PillarProblem> problems(const PillarValues& values) {
    return corner_problems(corners(values), values.number("corner_radius_um"));
  }
  static Polygon from(const PillarValues& values) {
    return Polygon(corners(values), values.number("corner_radius_um"));
  }
  using ContourPillar::ContourPillar;

 private:
  static std::vector<Point2> corners(const PillarValues& values) {
    const int sides = static_cast<int>(values.number("sides"));
    const double radius = values.number("circumradius_um"), rotation = values.number("rotation_deg");
    std::vector<Point2> points;
    for (int k = 0; k < sides; ++k)
      points.push_back(rotated({{0.0, radius}}, rotation + 360.0 * k / sides)[0]);
    return points;
  }
};

}  // namespace dld
