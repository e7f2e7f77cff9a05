#include "scene/device_output.hpp"

#include <cmath>
#include <numbers>

namespace dld {

void write_device(RunContext& context, const Device& device, double um_per_lu) {
  const double um = um_per_lu;
  // Whole nanometres' millionths: what the scaling with the lattice spacing adds is rounding.
  const auto length = [um](double lu) { return std::round(1e9 * lu * um) / 1e9; };
  const PillarArray& pillars = device.pillars();
  const GapLine gap = device.gap_line();
  const double cell_area = pillars.pitch_x() * pillars.pitch_y();
  std::vector<Point2> outline = pillars.shape().outline();
  for (Point2& p : outline) p = {length(p[0]), length(p[1])};
  context.summary["device"] = {{"pitch_x_um", length(pillars.pitch_x())},
                               {"pitch_y_um", length(pillars.pitch_y())},
                               {"row_shift_um", length(pillars.row_shift())},
                               {"tilt_deg", device.tilt() * 180 / std::numbers::pi},
                               {"gap_um", length(device.gap())},
                               {"gap_line_x_um", length(gap.x)},
                               {"surface_below_um", length(gap.lower)},
                               {"surface_above_um", length(gap.upper)},
                               {"length_scale_um", length(length_scale(device.gap(), device.depth()))},
                               {"open_area_um2", std::round(1e9 * device.open_area() * um * um) / 1e9},
                               {"open_share", device.open_area() / cell_area},
                               {"outline_um", outline}};
  if (outline.empty()) return;
  std::vector<double> points;
  for (const Point2& p : outline) points.insert(points.end(), p.begin(), p.end());
  context.out.write(
      "/device/outline_um", std::span<const double>(points), {outline.size(), 2}, "um",
      "outline of a pillar about its centre, counter-clockwise; the last point joins the first");
}

}  // namespace dld
