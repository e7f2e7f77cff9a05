#include "parameters/start_check.hpp"

#include <cmath>
#include <utility>

#include "parameters/cell_check.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/device_check.hpp"
#include "parameters/text.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

void check_start_height(const Case& c, std::vector<Problem>& problems) {
  const auto& start = c.cell.start;
  if (c.geometry.height == "half") {
    for (const auto& [name, value] : {std::pair{"z_um", start.z_um}, std::pair{"tilt_deg", start.tilt_deg}}) {
      if (value == 0) continue;
      problems.push_back({std::string("/cell/start/") + name, number_text(value),
                          "0 with half height (mirror plane)", "use 0, or \"full\" for /geometry/height"});
    }
    if (start.z_um != 0 || start.tilt_deg != 0) return;
  }
  const HeightRange cell = height_range_um(c.cell);
  const double lowest_um = -c.geometry.depth_um / 2 - cell.lowest,
               highest_um = c.geometry.depth_um / 2 - cell.highest;
  if (lowest_um >= highest_um) {
    problems.push_back(
        {size_pointer(c.cell), size_text(c.cell),
         "a cell that fits in the depth of " + number_text(c.geometry.depth_um) + " um at the start",
         "use a smaller cell or tilt, or a larger /geometry/depth_um"});
  } else if (start.z_um <= lowest_um || start.z_um >= highest_um) {
    const double nearest_um =
        start.z_um < 0 ? std::ceil(10 * lowest_um) / 10 : std::floor(10 * highest_um) / 10;
    problems.push_back({"/cell/start/z_um", number_text(start.z_um),
                        "above " + number_text(lowest_um) + " and below " + number_text(highest_um),
                        "use " + number_text(nearest_um)});
  }
}

// Where the solver chooses the height of the start, there must be one to choose.
void check_room(const Case& c, const Device& device, std::vector<Problem>& problems) {
  const double x_um = c.cell.start.x_um, room_um = device.room_on_line(x_um);
  const double tolerance_um = device.pillars().pitch_y() / 400;
  const auto fits = [&](double x) { return device.room_on_line(x) + tolerance_um >= c.cell.radius_um; };
  if (fits(x_um)) return;
  std::string advice =
      "use a smaller /cell/radius_um, or start deformed cells by hand: there is no such line";
  for (const double x : {device.start_x(), device.gap_line().x - device.pillars().pitch_x()})
    if (fits(x)) advice = "use " + number_text(x);
  problems.push_back(
      {"/cell/start/x_um", number_text(x_um),
       "a line on which the undeformed cell fits between the pillars (there is room for a radius of " +
           number_text(room_um) + " um)",
       advice});
}

// The undeformed cell must not cut a pillar where it starts. A circle about its centre is a safe bound.
void check_start_in_plane(const Case& c, std::vector<Problem>& problems) {
  const auto& start = c.cell.start;
  std::vector<Problem> of_pillar;
  if (!check_pillar(c, of_pillar)) return;
  const Device device = device_um(c);
  if (device.empty()) return;
  if (start.gap_position_um < 0) return check_room(c, device, problems);
  const GapLine gap = device.gap_line();
  const double room_um = device.pillars().signed_distance(start.x_um, gap.lower + start.gap_position_um) -
                         in_plane_radius_um(c.cell);
  if (room_um >= 0) return;
  problems.push_back({"/cell/start/gap_position_um", number_text(start.gap_position_um),
                      "a start at which the undeformed cell touches no pillar (it overlaps by " +
                          number_text(-room_um) + " um)",
                      "use " + number_text(gap.middle() - gap.lower) + " (the middle of the gap), or " +
                          number_text(device.start_x()) + " for /cell/start/x_um (between two rows)"});
}

// Rows are counted from the gap line of row 0, which the centre must have before it.
void check_start_row(const Case& c, std::vector<Problem>& problems) {
  std::vector<Problem> of_pillar;
  if (!check_pillar(c, of_pillar)) return;
  const Device device = device_um(c);
  const double x_um = c.cell.start.x_um, dx = c.fluid.lattice_spacing_um, line_um = device.gap_line().x;
  if (x_um <= line_um - dx) return;
  problems.push_back({"/cell/start/x_um", number_text(x_um),
                      "at most " + number_text(line_um - dx) +
                          ", a lattice spacing before the pillar line x = " + number_text(line_um),
                      "use " + number_text(device.start_x()) + " (between two rows)"});
}

}  // namespace

void check_start(const Case& c, std::vector<Problem>& problems) {
  check_start_row(c, problems);
  check_start_height(c, problems);
  check_start_in_plane(c, problems);
}

}  // namespace dld
