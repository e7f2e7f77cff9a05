#pragma once
/// Pillar with the cross-section of an I: two flanges joined by a web.
#include "geometry/contour_pillar.hpp"

namespace dld {

class IShape final : public ContourPillar {
 public:
  static constexpr const char* doc = "an I about the middle of its web; rotation 0 has the web along y";
  static std::vector<PillarParameter> parameters() {
    return {length_parameter("width_um", 14, "length of the two flanges"),
            length_parameter("height_um", 20, "from outside to outside of the flanges"),
            length_parameter("web_um", 5, "thickness of the web, less than the width"),
            length_parameter("flange_um", 5, "thickness of a flange, less than half the height"),
            rotation_parameter(),
            corner_radius_parameter()};
  }
  static std::vector<PillarProblem> problems(const PillarValues& values) {
    std::vector<PillarProblem> found;
    require_less(values, "web_um", values.number("width_um"), "the width", found);
    require_less(values, "flange_um", 0.5 * values.number("height_um"), "half the height", found);
    return found.empty() ? corner_problems(corners(values), values.number("corner_radius_um")) : found;
  }
  static IShape from(const PillarValues& values) {
    return IShape(corners(values), values.number("corner_radius_um"));
  }
  using ContourPillar::ContourPillar;

 private:
  static std::vector<Point2> corners(const PillarValues& values) {
    const double x = 0.5 * values.number("width_um"), y = 0.5 * values.number("height_um");
    const double web = 0.5 * values.number("web_um"), inner = y - values.number("flange_um");
    return rotated({{-x, -y},
                    {x, -y},
                    {x, -inner},
                    {web, -inner},
                    {web, inner},
                    {x, inner},
                    {x, y},
                    {-x, y},
                    {-x, inner},
                    {-web, inner},
                    {-web, -inner},
                    {-x, -inner}},
                   values.number("rotation_deg"));
  }
};

}  // namespace dld
