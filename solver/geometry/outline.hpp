#pragma once
/// Pillar whose outline is a polygon with its points in the case, for shapes from a drawing.
#include "geometry/contour_pillar.hpp"

namespace dld {

class Outline final : public ContourPillar {
 public:
  static constexpr const char* doc = "a closed polygon, its points relative to the pillar's centre";
  static std::vector<PillarParameter> parameters() {
    return {{.name = "points_um",
             .kind = PillarParameter::Kind::points,
             .example = {-9, -7, 10, -9, 4, 1, 9, 10, -8, 8},
             .minimum = -1000,
             .maximum = 1000,
             .unit = "um",
             .doc = "corners [x, y] in counter-clockwise order; the last joins the first by itself"},
            corner_radius_parameter()};
  }
  static std::vector<PillarProblem> problems(const PillarValues& values) {
    const auto points = values.points("points_um");
    const auto found = polygon_problems("points_um", points);
    return found.empty() ? corner_problems(points, values.number("corner_radius_um")) : found;
  }
  static Outline from(const PillarValues& values) {
    return Outline(values.points("points_um"), values.number("corner_radius_um"));
  }
  using ContourPillar::ContourPillar;
};

}  // namespace dld
