#pragma once
/// Pillar with the cross-section of an L: a stem with a foot.
#include "geometry/contour_pillar.hpp"

namespace dld {

class LShape final : public ContourPillar {
 public:
  static constexpr const char* doc =
      "an L about the middle of the box around it; rotation 0 has the stem along y and the foot towards +x";
  static std::vector<PillarParameter> parameters() {
    return {length_parameter("width_um", 16, "length of the foot, the stem included"),
            length_parameter("height_um", 20, "length of the stem, the foot included"),
            length_parameter("stem_um", 6, "thickness of the stem, less than the width"),
            length_parameter("foot_um", 6, "thickness of the foot, less than the height"),
            rotation_parameter(),
            corner_radius_parameter()};
  }
  static std::vector<PillarProblem> problems(const PillarValues& values) {
    std::vector<PillarProblem> found;
    require_less(values, "stem_um", values.number("width_um"), "the width", found);
    require_less(values, "foot_um", values.number("height_um"), "the height", found);
    return found.empty() ? corner_problems(corners(values), values.number("corner_radius_um")) : found;
  }
  static LShape from(const PillarValues& values) {
    return LShape(corners(values), values.number("corner_radius_um"));
  }
  using ContourPillar::ContourPillar;

 private:
  static std::vector<Point2> corners(const PillarValues& values) {
    const double x = 0.5 * values.number("width_um"), y = 0.5 * values.number("height_um");
    const double stem = values.number("stem_um") - x, foot = values.number("foot_um") - y;
    return rotated({{-x, -y}, {x, -y}, {x, foot}, {stem, foot}, {stem, y}, {-x, y}},
                   values.number("rotation_deg"));
  }
};

}  // namespace dld
