#include "parameters/device_check.hpp"

#include <algorithm>
#include <cmath>

#include "parameters/advice.hpp"
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

void check_depth(const Case& c, std::vector<Problem>& problems) {
  const double dx = c.fluid.lattice_spacing_um;
  const bool half = c.geometry.height == "half";
  check_multiple(c, "/geometry/depth_um", c.geometry.depth_um, half ? 2 * dx : dx,
                 half ? "2 lattice spacings (half height)" : "the lattice spacing", false, problems);
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

}  // namespace dld
