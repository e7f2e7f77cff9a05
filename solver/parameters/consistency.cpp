#include "parameters/consistency.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "parameters/memory.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

// Lengths are decimal numbers in um; this much of a lattice spacing is rounding.
constexpr double rounding = 1e-6;

// Half the largest thickness of the red blood cell shape, in units of its radius.
constexpr double half_thickness_ratio = 0.33;

// A length that must be a multiple of `unit_um`, the spacing or twice the spacing.
void check_multiple(const std::string& pointer, double length_um, double unit_um,
                    const std::string& unit_name, bool zero_allowed, std::vector<Problem>& problems) {
  const double n = std::round(length_um / unit_um);
  const bool fits = std::abs(length_um / unit_um - n) < rounding && (zero_allowed || n >= 1);
  if (fits) return;
  const double nearest_um = std::max(zero_allowed ? 0.0 : 1.0, n) * unit_um;
  problems.push_back({pointer, number_text(length_um),
                      "a multiple of " + unit_name + " = " + number_text(unit_um) + " um",
                      "use " + number_text(nearest_um) + ", or change /fluid/lattice_spacing_um"});
}

void check_depth(const Case& c, std::vector<Problem>& problems) {
  const double dx = c.fluid.lattice_spacing_um;
  const bool half = c.geometry.height == "half";
  check_multiple("/geometry/depth_um", c.geometry.depth_um, half ? 2 * dx : dx,
                 half ? "2 lattice spacings (half height)" : "the lattice spacing", false, problems);
}

void check_array(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  const double dx = c.fluid.lattice_spacing_um;
  check_multiple("/geometry/pitch_um", g.pitch_um, dx, "the lattice spacing", false, problems);
  check_multiple("/geometry/row_shift_um", g.row_shift_um, dx, "the lattice spacing", true, problems);
  if (2 * g.pillar_radius_um >= g.pitch_um) {
    problems.push_back(
        {"/geometry/pillar_radius_um", number_text(g.pillar_radius_um),
         "less than half the pitch of " + number_text(g.pitch_um) + " um",
         "use at most " + number_text(g.pitch_um / 2 - dx) + " (a gap of two lattice spacings)"});
  }
  if (g.row_shift_um >= g.pitch_um) {
    problems.push_back(
        {"/geometry/row_shift_um", number_text(g.row_shift_um),
         "less than the pitch of " + number_text(g.pitch_um) + " um",
         "use " + number_text(std::fmod(g.row_shift_um, g.pitch_um)) + ", which is the same array"});
  }
}

// Largest extent of the start shape from its centre along z (an upper bound).
double half_extent_z_um(const CellParameters& cell) {
  if (cell.shape == "sphere") return cell.radius_um;
  const double tilt = cell.start.tilt_deg * std::numbers::pi / 180;
  return cell.radius_um * (std::abs(std::sin(tilt)) + half_thickness_ratio * std::abs(std::cos(tilt)));
}

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
  const double room_um = c.geometry.depth_um / 2 - half_extent_z_um(c.cell);
  if (room_um <= 0) {
    problems.push_back(
        {"/cell/radius_um", number_text(c.cell.radius_um),
         "a cell that fits in the depth of " + number_text(c.geometry.depth_um) + " um at the start",
         "use a smaller radius or tilt, or a larger /geometry/depth_um"});
  } else if (std::abs(start.z_um) >= room_um) {
    problems.push_back({"/cell/start/z_um", number_text(start.z_um),
                        "less than " + number_text(room_um) + " in magnitude",
                        "use " + number_text(std::copysign(std::floor(10 * room_um) / 10, start.z_um))});
  }
}

// The undeformed cell must not cut a pillar where it starts. Circles about the pillars are a safe bound.
void check_start_in_plane(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  const auto& start = c.cell.start;
  if (g.pillar_shape == "none" || start.gap_position_um < 0 || 2 * g.pillar_radius_um >= g.pitch_um) return;
  const double y_um = g.pillar_radius_um + start.gap_position_um;
  const double column = std::round(start.x_um / g.pitch_um);
  double nearest_um = g.pitch_um;
  for (const double n : {column - 1, column, column + 1}) {
    const double dy = std::remainder(y_um - n * g.row_shift_um, g.pitch_um);
    nearest_um = std::min(nearest_um, std::hypot(start.x_um - n * g.pitch_um, dy));
  }
  const double room_um = nearest_um - g.pillar_radius_um - c.cell.radius_um;
  if (room_um >= 0) return;
  problems.push_back({"/cell/start/gap_position_um", number_text(start.gap_position_um),
                      "a start at which the undeformed cell touches no pillar (it overlaps by " +
                          number_text(-room_um) + " um)",
                      "use " + number_text(g.pitch_um / 2 - g.pillar_radius_um) +
                          " (the middle of the gap), or " + number_text(-g.pitch_um / 2) +
                          " for /cell/start/x_um (between two rows)"});
}

// Rows are counted from the pillar line x = 0, which the centre must have before it.
void check_start_row(const Case& c, std::vector<Problem>& problems) {
  const double x_um = c.cell.start.x_um, dx = c.fluid.lattice_spacing_um;
  if (x_um <= -dx) return;
  problems.push_back({"/cell/start/x_um", number_text(x_um),
                      "at most " + number_text(-dx) + ", a lattice spacing before the pillar line x = 0",
                      "use " + number_text(-c.geometry.pitch_um / 2) + " (between two rows)"});
}

// Places of populations are counted with 32 bits.
void check_size(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  const double dx = c.fluid.lattice_spacing_um, halves = g.height == "half" ? 0.5 : 1.0;
  const double volume_um3 = g.pitch_um * g.pitch_um * g.depth_um * halves;
  constexpr double directions = 19, most_nodes = 4294967296.0 / directions;
  if (volume_um3 / (dx * dx * dx) < most_nodes) return;
  problems.push_back(
      {"/fluid/lattice_spacing_um", number_text(dx),
       "at most " + number_text(std::floor(most_nodes)) + " nodes in the unit cell",
       "use at least " + number_text(std::ceil(1e4 * std::cbrt(volume_um3 / most_nodes)) / 1e4)});
}

void check_passage(const Case& c, std::vector<Problem>& problems) {
  check_array(c, problems);
  check_depth(c, problems);
  check_size(c, problems);
  check_start_row(c, problems);
  check_start_height(c, problems);
  check_start_in_plane(c, problems);
  if (c.geometry.row_shift_um == 0 && c.stop.max_rows == 0) {
    problems.push_back({"/stop/max_rows", "0", "a number of rows when the rows are not shifted",
                        "use e.g. 10, or a row shift above 0"});
  }
  if (c.stop.when == "rows" && c.stop.max_rows == 0) {
    problems.push_back({"/stop/max_rows", "0", "a number of rows when /stop/when is rows",
                        "use e.g. 50, or \"decided\" for /stop/when"});
  }
}

void check_streamlines(const Case& c, std::vector<Problem>& problems) {
  check_array(c, problems);
  check_depth(c, problems);
  check_size(c, problems);
}

// Some vertex has to lie within the patch that is pulled at. Meshes of an even frequency have one at the tip.
void check_stretching(const Case& c, std::vector<Problem>& problems) {
  // The icosahedral mesh has n edges along an arc of 63 degrees.
  const double half_edge_um = 0.55 * c.cell.radius_um / c.cell.mesh_frequency;
  const bool reaches = c.cell.mesh_frequency % 2 == 0 || c.stretching.contact_radius_um >= half_edge_um;
  if (reaches && c.stretching.contact_radius_um < c.cell.radius_um) return;
  problems.push_back({"/stretching/contact_radius_um", number_text(c.stretching.contact_radius_um),
                      "at least half an edge of the mesh, " +
                          number_text(std::ceil(100 * half_edge_um) / 100) +
                          " um, where its frequency is odd, and less than the radius of the cell",
                      "use 1, or take an even /cell/mesh_frequency"});
}

// A force that the minimiser cannot tell from none, or that no membrane bears: F over the tension kS r.
void check_forces(const Case& c, std::vector<Problem>& problems) {
  constexpr double weakest = 1e-3, strongest = 2e3;
  const double tension_pN = c.stretching.shear_modulus_uN_per_m * c.cell.radius_um;  // 1 uN/m um = 1 pN
  for (const double force : c.stretching.forces_pN) {
    const double share = force / tension_pN;
    if (force == 0.0 || (share >= weakest && share <= strongest)) continue;
    problems.push_back({"/stretching/forces_pN", number_text(force),
                        "0, or between " + number_text(weakest * tension_pN) + " and " +
                            number_text(strongest * tension_pN) + " pN (" + number_text(weakest) + " to " +
                            number_text(strongest) + " times shear modulus times radius)",
                        "change the force or /stretching/shear_modulus_uN_per_m"});
  }
  constexpr std::size_t most = 1000;
  if (c.stretching.forces_pN.size() > most)
    problems.push_back({"/stretching/forces_pN",
                        number_text(static_cast<double>(c.stretching.forces_pN.size())),
                        "a list of at most " + number_text(most) + " forces", "split it into several cases"});
}

// Places of populations are counted with 32 bits.
void check_box(const Case& c, std::vector<Problem>& problems) {
  constexpr double directions = 19, most_nodes = 4294967296.0 / directions;
  const double nodes = fluid_box(c).nodes(), dx = c.fluid.lattice_spacing_um;
  if (nodes < most_nodes) return;
  problems.push_back(
      {"/fluid/lattice_spacing_um", number_text(dx),
       "at most " + number_text(std::floor(most_nodes)) + " nodes in the box",
       "use at least " + number_text(std::ceil(1e4 * dx * std::cbrt(nodes / most_nodes)) / 1e4)});
}

// Neither a duration of a few steps nor one that can never be reached.
void check_duration(const Case& c, std::vector<Problem>& problems) {
  constexpr double fewest = 20;
  const double radius = c.cell.radius_um / c.fluid.lattice_spacing_um;
  const double per_time = radius * radius / (c.shear.reynolds_number * (c.fluid.relaxation_time - 0.5) / 3);
  const double steps = c.shear.duration * per_time;
  if (steps < fewest) {
    problems.push_back({"/shear/duration", number_text(c.shear.duration),
                        "at least " + number_text(fewest) + " time steps",
                        "use at least " + number_text(fewest / per_time)});
  } else if (steps > static_cast<double>(c.stop.max_steps)) {
    problems.push_back({"/shear/duration", number_text(c.shear.duration),
                        "at most the " + number_text(static_cast<double>(c.stop.max_steps)) +
                            " steps of /stop/max_steps; these are " + number_text(std::ceil(steps)),
                        "use at most " + number_text(static_cast<double>(c.stop.max_steps) / per_time) +
                            ", or raise /stop/max_steps or /shear/reynolds_number"});
  }
}

void check_channel(const Case& c, std::vector<Problem>& problems) {
  check_depth(c, problems);
  check_multiple("/channel/width_um", c.channel.width_um, c.fluid.lattice_spacing_um, "the lattice spacing",
                 true, problems);
  check_box(c, problems);
}

void check_shear(const Case& c, std::vector<Problem>& problems) {
  check_multiple("/shear/box_um", c.shear.box_um, c.fluid.lattice_spacing_um, "the lattice spacing", false,
                 problems);
  if (2 * c.cell.radius_um >= c.shear.box_um) {
    problems.push_back({"/cell/radius_um", number_text(c.cell.radius_um),
                        "less than half the box of " + number_text(c.shear.box_um) + " um",
                        "use at most " + number_text(c.shear.box_um / 4) + " for a quarter of the box"});
  }
}

}  // namespace

std::vector<Problem> inconsistencies(const Case& c) {
  std::vector<Problem> problems;
  if (c.scene == "passage") check_passage(c, problems);
  if (c.scene == "streamlines") check_streamlines(c, problems);
  if (c.scene == "stretching") {
    check_stretching(c, problems);
    check_forces(c, problems);
    check_box(c, problems);
  }
  if (c.scene == "channel") check_channel(c, problems);
  if (c.scene == "shear") {
    check_shear(c, problems);
    check_duration(c, problems);
    check_box(c, problems);
  }
  return problems;
}

}  // namespace dld
