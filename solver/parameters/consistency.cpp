#include "parameters/consistency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parameters/advice.hpp"
#include "parameters/cell_check.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/scene_rules.hpp"
#include "parameters/text.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

// Lengths are decimal numbers in um; this much of a lattice spacing is rounding.
constexpr double rounding = 1e-6;

// What the proposed length does to an epsilon that follows from two lengths.
std::string epsilon_text(const Case& c, const std::string& pointer, double length_um) {
  const auto& g = c.geometry;
  if (pointer == "/geometry/row_shift_um")
    return ", which is epsilon " + number_text(length_um / g.pitch_across_um());
  if (pointer == "/geometry/pitch_um" && !g.by_epsilon && g.row_shift_um > 0)
    return ", which makes epsilon " + number_text(g.row_shift_um / length_um);
  return "";
}

}  // namespace

void check_multiple(const Case& c, const std::string& pointer, double length_um, double unit_um,
                    const std::string& unit_name, bool zero_allowed, std::vector<Problem>& problems) {
  const double n = std::round(length_um / unit_um);
  const bool fits = std::abs(length_um / unit_um - n) < rounding && (zero_allowed || n >= 1);
  if (fits) return;
  const double nearest_um = std::max(zero_allowed ? 0.0 : 1.0, n) * unit_um;
  problems.push_back({pointer, number_text(length_um),
                      "a multiple of " + unit_name + " = " + number_text(unit_um) + " um",
                      "use " + number_text(nearest_um) + epsilon_text(c, pointer, nearest_um) + ", or " +
                          fitting_spacings(c)});
}

// A row shift that was given as epsilon is spoken of as such: nothing rounds it in silence.
void check_row_shift(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  const double dx = c.fluid.lattice_spacing_um;
  const std::size_t before = problems.size();
  check_multiple(c, "/geometry/row_shift_um", g.row_shift_um, dx, "the lattice spacing", true, problems);
  if (problems.size() == before || !g.by_epsilon) return;
  const double nearest_um = std::round(g.row_shift_um / dx) * dx;
  Problem& problem = problems.back();
  problem.pointer = "/geometry/epsilon";
  problem.value = number_text(g.row_shift_um / g.pitch_across_um());
  problem.allowed = "a row shift, " + number_text(g.row_shift_um) + " um, that is " + problem.allowed;
  problem.advice = "use " + number_text(nearest_um / g.pitch_across_um()) + ", a row shift of " +
                   number_text(nearest_um) + " um, or " + fitting_spacings(c);
}

void check_depth(const Case& c, std::vector<Problem>& problems) {
  const double dx = c.fluid.lattice_spacing_um;
  const bool half = c.geometry.height == "half";
  check_multiple(c, "/geometry/depth_um", c.geometry.depth_um, half ? 2 * dx : dx,
                 half ? "2 lattice spacings (half height)" : "the lattice spacing", false, problems);
}

namespace {
// Fewer lattice spacings than these between two pillars, or across one, give no flow to measure: at a gap of
// half a spacing s is 0. Below the others the flow is there and not accurate (limits.cpp).
constexpr double least_gap = 2, least_pillar = 2;

// Gap and pillar on the lattice.
void check_resolution(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  const Device device = device_um(c);
  if (device.empty()) return;
  const double dx = c.fluid.lattice_spacing_um;
  const std::string pointer = g.pillar ? "/geometry/pillar" : "/geometry/pillar_radius_um";
  const std::string value = g.pillar ? g.pillar->shape : number_text(g.pillar_radius_um);
  const double gap = device.narrowest_gap() / dx, thinnest = device.thinnest_extent() / dx;
  if (gap < least_gap * (1 - rounding)) {
    problems.push_back({pointer, value,
                        "a gap of at least " + number_text(least_gap) +
                            " lattice spacings between two pillars (it is " + number_text(gap) + ")",
                        "use at most " + number_text(gap * dx / least_gap) +
                            " for /fluid/lattice_spacing_um, a smaller pillar or a larger pitch"});
  }
  if (thinnest < least_pillar * (1 - rounding)) {
    problems.push_back(
        {pointer, value,
         "a pillar of at least " + number_text(least_pillar) +
             " lattice spacings along and across the flow (it has " + number_text(thinnest) + ")",
         "use at most " + number_text(thinnest * dx / least_pillar) +
             " for /fluid/lattice_spacing_um, a larger pillar, or the shape none for an empty slit"});
  }
}

// The pillar by itself; false if there is none to ask further.
bool check_pillar(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  const double dx = c.fluid.lattice_spacing_um, pitch_um = std::min(g.pitch_um, g.pitch_across_um());
  if (!g.pillar) {
    if (2 * g.pillar_radius_um < pitch_um) return true;
    problems.push_back(
        {"/geometry/pillar_radius_um", number_text(g.pillar_radius_um),
         "less than half the pitch of " + number_text(pitch_um) + " um",
         "use at most " + number_text(pitch_um / 2 - dx) + " (a gap of two lattice spacings)"});
    return false;
  }
  const auto found = pillar_problems(*g.pillar);
  for (const PillarProblem& p : found)
    problems.push_back({"/geometry/pillar/" + p.parameter, p.value, p.allowed, p.advice});
  if (!found.empty()) return false;
  const double gap_um = device_um(c).narrowest_gap();
  if (gap_um > 0) return true;
  problems.push_back(
      {"/geometry/pillar", g.pillar->shape,
       "a pillar that touches none of its neighbours (they overlap by " + number_text(-gap_um) + " um)",
       "use a smaller pillar, or a larger /geometry/pitch_um or /geometry/pitch_y_um"});
  return false;
}

// Of a square array driven at an angle: any shift over a pitch, which is the tangent of the angle.
void check_rotated_square(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  if (check_pillar(c, problems)) check_resolution(c, problems);
  if (g.pitch_across_um() != g.pitch_um) {
    problems.push_back(
        {"/geometry/pitch_y_um", number_text(g.pitch_across_um()),
         "the pitch of " + number_text(g.pitch_um) + " um where /geometry/layout is rotated_square",
         "remove it, or use row_shifted for /geometry/layout"});
  }
  if (g.row_shift_um > g.pitch_um) {
    problems.push_back({"/geometry/row_shift_um", number_text(g.row_shift_um),
                        "at most the pitch of " + number_text(g.pitch_um) + " um, a tilt of 45 degrees",
                        "use " + number_text(g.pitch_um * g.pitch_um / g.row_shift_um) +
                            ", which is the same array seen along its other rows"});
  }
}

void check_array(const Case& c, std::vector<Problem>& problems) {
  const auto& g = c.geometry;
  const double dx = c.fluid.lattice_spacing_um, pitch_y_um = g.pitch_across_um();
  check_multiple(c, "/geometry/pitch_um", g.pitch_um, dx, "the lattice spacing", false, problems);
  if (g.pitch_y_um)
    check_multiple(c, "/geometry/pitch_y_um", pitch_y_um, dx, "the lattice spacing", false, problems);
  if (g.rotated_square()) return check_rotated_square(c, problems);
  check_row_shift(c, problems);
  if (check_pillar(c, problems)) check_resolution(c, problems);
  if (g.row_shift_um >= pitch_y_um) {
    problems.push_back(
        {"/geometry/row_shift_um", number_text(g.row_shift_um),
         "less than the pitch of " + number_text(pitch_y_um) + " um",
         "use " + number_text(std::fmod(g.row_shift_um, pitch_y_um)) + ", which is the same array"});
  }
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

// Places of populations are counted with 32 bits.
void check_box(const Case& c, std::vector<Problem>& problems) {
  constexpr double directions = 19, most_nodes = 4294967296.0 / directions;
  const double nodes = rules_of(c.scene).box(c).nodes(), dx = c.fluid.lattice_spacing_um;
  if (nodes < most_nodes) return;
  problems.push_back(
      {"/fluid/lattice_spacing_um", number_text(dx),
       "at most " + number_text(std::floor(most_nodes)) + " nodes in the box",
       "use at least " + number_text(std::ceil(1e4 * dx * std::cbrt(nodes / most_nodes)) / 1e4)});
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

}  // namespace

void check_passage(const Case& c, std::vector<Problem>& problems) {
  check_array(c, problems);
  check_depth(c, problems);
  check_box(c, problems);
  check_start_row(c, problems);
  check_start_height(c, problems);
  check_start_in_plane(c, problems);
  check_width(c, problems);
  check_mirror(c, c.geometry.height == "half", problems);
  check_edges(c, problems);
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
  check_box(c, problems);
}

// Some vertex has to lie within the patch that is pulled at. Meshes of an even frequency have one at the tip.
void check_stretching(const Case& c, std::vector<Problem>& problems) {
  check_forces(c, problems);
  check_box(c, problems);
  const bool coupled = c.stretching.method == "coupled";
  check_mirror(c, coupled, problems);
  if (coupled) check_edges(c, problems);
  if (!sized_by_radius(c.cell)) return check_patches(c, problems);
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

void check_channel(const Case& c, std::vector<Problem>& problems) {
  check_depth(c, problems);
  check_multiple(c, "/channel/width_um", c.channel.width_um, c.fluid.lattice_spacing_um,
                 "the lattice spacing", true, problems);
  check_box(c, problems);
}

void check_shear(const Case& c, std::vector<Problem>& problems) {
  check_duration(c, problems);
  check_box(c, problems);
  check_multiple(c, "/shear/box_um", c.shear.box_um, c.fluid.lattice_spacing_um, "the lattice spacing", false,
                 problems);
  check_edges(c, problems);
  if (2 * reach_um(c.cell) >= c.shear.box_um) {
    problems.push_back(
        {size_pointer(c.cell), size_text(c.cell),
         "a reach from the centre of less than half the box of " + number_text(c.shear.box_um) + " um",
         "use at most " + number_text(c.shear.box_um / 4) + " for a quarter of the box"});
  }
}

std::vector<Problem> inconsistencies(const Case& c) {
  std::vector<Problem> problems;
  rules_of(c.scene).check(c, problems);
  return problems;
}

}  // namespace dld
