#pragma once
/// Teardrop, the simplest airfoil: a round nose and straight sides to a sharp tail.
#include <cmath>

#include "geometry/contour_pillar.hpp"

namespace dld {

class Teardrop final : public ContourPillar {
 public:
  static constexpr const char* doc =
      "a teardrop; rotation 0 has the round nose towards -x and the sharp tail towards +x";
  static std::vector<PillarParameter> parameters() {
    return {length_parameter("length_um", 20, "from nose to tail"),
            length_parameter("width_um", 12, "diameter of the nose, less than the length"),
            rotation_parameter()};
  }
  static std::vector<PillarProblem> problems(const PillarValues& values) {
    const double length = values.number("length_um"), width = values.number("width_um");
    if (width < length) return {};
    return {{"width_um", number_text(width), "less than the length of " + number_text(length) + " um",
             "use a smaller width, or the shape circle"}};
  }
  static Teardrop from(const PillarValues& values) {
    // A triangle whose two front corners are rounded by its inscribed circle, the nose: what is left of the
    // front is one point.
    const double length = values.number("length_um"), nose = 0.5 * values.number("width_um");
    const double half_front = length * std::tan(std::asin(nose / (length - nose)));
    const std::vector<Point2> corners{
        {0.5 * length, 0}, {-0.5 * length, half_front}, {-0.5 * length, -half_front}};
    return Teardrop(rotated(corners, values.number("rotation_deg")), {0, nose, nose});
  }
  using ContourPillar::ContourPillar;
};

}  // namespace dld
