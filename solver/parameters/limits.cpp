#include "parameters/limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "membrane/bending_law.hpp"
#include "membrane/mesh_check.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/flow_estimate.hpp"
#include "parameters/scene_rules.hpp"
#include "parameters/text.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

// Explicit coupling. Derived: nodal stiffness times sum phi^2, a node's own share in its velocity, must stay
// below 2 to 4; the lower bound is taken. That of bending is 55 kB / edge^2 for hinges with c = sqrt(3).
constexpr double stiffness_limit = 2.0;
// Fitted, phi4, tau 0.8, edge 1, a cell at rest for 400 steps: it bears an area modulus K of 8 / n and
// of bending (55 kB / edge^2) of 92 / n^1.4 (n = 1, 2, 4 steps per update), the latter 4.9 times sum phi^2.
// Half of that is the limit, since a deformed membrane is stiffer; passages at tau 1.9 bear K = 3.8 and
// not 4.5. For the narrow kernels it rests on sum phi^2 alone.
constexpr double area_modulus_limit = 3.8, bending_exponent = 1.4;
// A passage with one step per update bears less bending stiffness the larger the viscosity and the more
// lattice spacings there are in the radius r (lu). Fitted: 0.81 / sqrt(nu) at r = 9.75 (nu = 0.1, 0.2, 0.33,
// 0.47: 2.6, 1.8, 1.4, 1.2), 1.3 to 1.5 / sqrt(nu) at 4.9; at 19.5 0.55 ran and 0.68 did not. More steps per
// update bear the 2.4 above at any of these viscosities.
double bending_limit(double viscosity, double radius) {
  return std::min(2.4, 0.78 / std::sqrt(viscosity) * std::pow(9.75 / radius, 0.4));
}
// Fitted: with a shear modulus that is small against the area modulus the mesh buckles below the kernel's
// width; K^2 n / G (lu) at which it does, by kernel. And the least area modulus, in units of p' l r, at which
// faces do not collapse under the flow.
double buckling_limit(const std::string& kernel) {
  return kernel == "phi2" ? 180.0 : 1100.0;
}
constexpr double least_area_modulus = 1.5;
// Corrected kernel. Derived: a mode of wave number q (1 / dx) and stiffness (K + G) q^2 sees sum phi^2 = 3/8
// of its load, smoothed twice by exp(-0.55 q^2); the largest q^2 exp(-0.55 q^2) is 0.67. Explicit motion
// bears 2; of passages at tau 0.8 one with 1.45 (Ca 0.5) ran and one with 1.8 (Ca 0.1) did not.
constexpr double kink_symbol = 0.375 * 0.67, kink_limit = 1.6;
// Fitted on head-on starts with a range h0 of dx: least repulsion K / (p' l h0^2) times Ca that keeps a cell
// out of the pillar (0.009 did not, 0.015 did), and the Ca above which it touches the bottom or top wall when
// these do not repel.
constexpr double least_repulsion = 0.012, wall_contact_capillary = 1.5;
// Fitted, full equilibrium: Reynolds number (slit, l = sqrt(G H)) from which a cell is driven to the wall.
constexpr double inertia_limit = 2.5;
// Largest modulus (lu) that explicit coupling was seen to bear.
constexpr double volume_modulus_limit = 1.2;
// Fitted with BGK, where tau - 1/2 is also the relaxation of the odd moments: cells at 0.2 and less were
// driven to a wall or the fluid diverged at every force density, at 0.3 at large ones, at 0.4 they ran.
constexpr double bgk_relaxation_limit = 0.25;
// Speed (lu) at which compressibility, of order (u/cs)^2 = 3 %, is no longer small, and the Mach number of
// 0.5 at which the monitors stop a run. The estimate below agrees with the largest speed to about 10 per
// cent.
constexpr double accurate_speed_limit = 0.1, speed_limit = 0.3;
constexpr double row_shift_limit = 0.5;
// Slip that is no longer small beside the other errors of a run on a coarse lattice.
constexpr double slip_limit = 0.05;
// Lattice spacings across the gap. Measured with a triangle and an ellipse: with 8 to 9 s is off by 18 and 40
// per cent, with 17 by 1 and 8 per cent, at second order. Too few to have a flow at all are refused
// (device_check.cpp).
constexpr double accurate_gap = 10;
// Density variation 3 f lambda, the pressure that the force builds up over a pitch, over cs^2. Fitted: the
// variation passes 0.1 at 0.11 and, with a cell, 0.3 above or below the mean, where the monitors stop, at
// 0.45.
constexpr double accurate_density_limit = 0.11, density_limit = 0.45;
// Mesh edge / dx: beyond the upper bound fluid leaks through (the volume is held by the projection alone),
// below the lower one the mesh has modes that the kernel cannot see. No run fails by either.
constexpr double longest_edge = 2.0, shortest_edge = 0.5;

// Largest value of sum phi^2 over the nodes of the 3D kernel: a node's own share in its velocity.
double kernel_self_weight(const std::string& kernel) {
  if (kernel.starts_with("phi4")) return 0.053;
  if (kernel == "phi3") return 0.125;
  return 1.0;  // phi2 on a fluid node
}

// Mean edge of the icosahedral mesh (lu): 1.00 for r = 9.75 and frequency 10.
double mean_edge(double radius, int frequency) {
  return radius / 9.75 * 10.0 / frequency;
}

Margin below(const std::string& name, double value, double limit, const std::string& unit,
             const std::string& advice, bool fails = true) {
  return {name, value, limit, value / limit, unit, value < limit, fails, advice};
}

Margin above(const std::string& name, double value, double limit, const std::string& unit,
             const std::string& advice, bool fails = true) {
  return {name, value, limit, limit / value, unit, value > limit, fails, advice};
}

const std::string softer = "reduce /fluid/force_density (at fixed Ca all moduli fall with it)";

// True moduli of the Skalak law at small strain: shear G = 4 kS/k, area K = G + 2 kalpha/3.
void membrane_margins(const Case& c, const LatticeParameters& l, double kink_mobility,
                      std::vector<Margin>& margins) {
  const double shear = 4 * l.shear_modulus / c.cell.skalak_denominator;
  const double area = shear + 2 * l.local_area_modulus / 3;
  const double steps = c.coupling.steps_per_update;
  const double weight = kernel_self_weight(c.coupling.kernel);
  const double edge = sized_by_radius(c.cell) ? mean_edge(l.cell_radius, c.cell.mesh_frequency)
                                              : edge_lengths(cell_mesh(c.cell, l.cell_radius)).mean;
  const double law = entry(bending_law_by_name(c.cell.bending_law)).relative_stiffness;
  const double bending = 55 * law * l.bending_modulus / (edge * edge) * weight;
  margins.push_back(below("in-plane stiffness 2 sqrt3 (K/2 + G) sum phi^2",
                          2 * std::numbers::sqrt3 * (area / 2 + shear) * weight, stiffness_limit, "lu",
                          softer + " or /cell/local_area_modulus, or use a wider kernel"));
  margins.push_back(below(
      "bending stiffness times sum phi^2, per update", bending * std::pow(steps, bending_exponent),
      bending_limit(l.viscosity, l.cell_radius), "lu",
      softer + ", /coupling/steps_per_update, /fluid/relaxation_time or /cell/mesh_frequency, or use phi4"));
  margins.push_back(below("area modulus, per update", area * steps, area_modulus_limit, "lu",
                          softer + ", /coupling/steps_per_update or /cell/local_area_modulus"));
  margins.push_back(below("area over shear modulus, K^2 / G per update", area * area / shear * steps,
                          buckling_limit(c.coupling.kernel), "lu",
                          softer + ", /cell/local_area_modulus or /cell/capillary_number"));
  if (kink_mobility > 0) {
    margins.push_back(below("stiffness K + G times what the corrected kernel gives back, per update",
                            steps * kink_mobility * kink_symbol * (area + shear), kink_limit, "",
                            softer + " or /coupling/steps_per_update"));
  }
  if (c.scene == "passage") {
    margins.push_back(above("least area modulus", area / l.tension_scale, least_area_modulus, "p' l r",
                            "raise /cell/local_area_modulus"));
  }
  if (c.cell.volume_control == "penalty") {
    margins.push_back(below("volume modulus", l.volume_modulus, volume_modulus_limit, "lu",
                            softer + " or /cell/volume_modulus, or use volume_control projection"));
  }
  margins.push_back(below("mesh edge / dx", edge, longest_edge, "lu",
                          "raise /cell/mesh_frequency: fluid leaks through a coarse mesh", false));
  margins.push_back(above("mesh edge / dx (lower bound)", edge, shortest_edge, "lu",
                          "lower /cell/mesh_frequency: the kernel does not see such short modes", false));
}

void contact_margins(const Case& c, std::vector<Margin>& margins) {
  const double ca = c.cell.capillary_number;
  const double range = c.coupling.repulsion_range;
  margins.push_back(above("pillar repulsion times Ca", c.coupling.pillar_repulsion * ca / (range * range),
                          least_repulsion, "p' l h0^2", "raise /coupling/pillar_repulsion"));
  if (c.coupling.wall_repulsion > 0) return;
  margins.push_back(below("Ca without repulsion from the walls", ca, wall_contact_capillary, "",
                          "set /coupling/wall_repulsion: so soft a cell may touch the walls", false));
}

void flow_margins(const Case& c, const LatticeParameters& l, std::vector<Margin>& margins) {
  // Shallow: twice the mean of an empty slit, f H^2 / (12 nu); between the pillars the flow is not faster.
  // Deep: the estimate for the device.
  const FlowEstimate flow = estimate_flow(c);
  const bool shallow = is_shallow(c);
  const double slit = 2 * l.force_density * l.depth * l.depth / (12 * l.viscosity);
  const double speed = shallow ? slit : flow.largest_speed;
  const double density = 3 * l.force_density * l.nx;
  const std::string slower = "reduce /fluid/force_density";
  margins.push_back(
      below(shallow ? "largest speed 2 f H^2 / (12 nu)" : "largest speed", speed, speed_limit, "lu", slower));
  margins.push_back(below("largest speed, for accuracy", speed, accurate_speed_limit, "lu", slower, false));
  margins.push_back(below("density variation 3 f lambda", density, density_limit, "", slower));
  margins.push_back(
      below("density variation, for accuracy", density, accurate_density_limit, "", slower, false));
  if (c.scene == "passage" && c.fluid.equilibrium == "full") {
    const double mean = shallow ? 0.5 * slit : flow.mean_speed;
    margins.push_back(below("Reynolds number", mean * l.length_scale / l.viscosity, inertia_limit, "",
                            slower + ", or raise /fluid/relaxation_time"));
  }
  if (c.scene == "passage" && c.fluid.collision == "bgk") {
    margins.push_back(above("relaxation time - 1/2, BGK", c.fluid.relaxation_time - 0.5, bgk_relaxation_limit,
                            "", "raise /fluid/relaxation_time, or use trt"));
  }
  margins.push_back(above("gap / dx", l.gap, accurate_gap, "lu",
                          "lower /fluid/lattice_spacing_um: s is off by tens of per cent", false));
  if (flow.lateral_share > 0) {
    const double loss = 1 - separation_ratio(c.geometry.epsilon(), flow.lateral_share);
    margins.push_back(
        below("lateral flow, share of epsilon", flow.lateral_share, lateral_share_limit, "",
              "the flow drifts along with the rows, which makes the separation distance s about " +
                  number_text(std::round(100 * loss)) +
                  " per cent smaller than between side walls: use blocked for /fluid/lateral_flow "
                  "where the device has side walls",
              false));
  }
  if (!c.geometry.rotated_square())
    margins.push_back(below("row shift / pitch", c.geometry.epsilon(), row_shift_limit, "",
                            "mirror the array: a shift d is a shift pitch - d to the other side", false));
}

// Half-way bounce-back at the top and the bottom puts the walls of a slit where its width is
// sqrt(H^2 + 16 Lambda / 3 - 1) (Ginzburg and d'Humieres 2003): the slip over the mean speed.
void slip_margin(const Case& c, const LatticeParameters& l, std::vector<Margin>& margins) {
  const double odd = c.fluid.relaxation_time - 0.5;
  const double magic = c.fluid.collision == "bgk" ? odd * odd : c.fluid.magic_parameter;
  const double slip = 1.5 * std::abs(16 * magic / 3 - 1) / (l.depth * l.depth);
  margins.push_back(below("slip at the bottom and the top wall", slip, slip_limit, "mean speed",
                          c.fluid.collision == "bgk" ? "use trt, or lower /fluid/relaxation_time"
                                                     : "use 0.1875 for /fluid/magic_parameter",
                          false));
}

// Speed of the walls of the sheared box.
void wall_speed_margins(const Case& c, const LatticeParameters& l, std::vector<Margin>& margins) {
  const double speed = 0.5 * l.shear_rate * c.shear.box_um / l.um_per_lu;
  const std::string slower = "reduce /shear/reynolds_number";
  margins.push_back(below("speed of the walls", speed, speed_limit, "lu", slower));
  margins.push_back(
      below("speed of the walls, for accuracy", speed, accurate_speed_limit, "lu", slower, false));
}

}  // namespace

std::vector<Margin> passage_margins(const Case& c, double kink_mobility) {
  const LatticeParameters l = scene_lattice(c);
  std::vector<Margin> margins;
  membrane_margins(c, l, kink_mobility, margins);
  contact_margins(c, margins);
  flow_margins(c, l, margins);
  slip_margin(c, l, margins);
  return margins;
}

std::vector<Margin> streamlines_margins(const Case& c) {
  std::vector<Margin> margins;
  flow_margins(c, scene_lattice(c), margins);
  slip_margin(c, scene_lattice(c), margins);
  return margins;
}

std::vector<Margin> stretching_margins(const Case& c, double kink_mobility) {
  std::vector<Margin> margins;
  if (c.stretching.method == "coupled") membrane_margins(c, scene_lattice(c), kink_mobility, margins);
  return margins;
}

std::vector<Margin> channel_margins(const Case& c) {
  std::vector<Margin> margins;
  slip_margin(c, scene_lattice(c), margins);
  return margins;
}

std::vector<Margin> shear_margins(const Case& c) {
  std::vector<Margin> margins;
  wall_speed_margins(c, scene_lattice(c), margins);
  return margins;
}

std::vector<Margin> stability_margins(const Case& c) {
  return rules_of(c.scene).margins(c);
}

bool expected_to_diverge(const std::vector<Margin>& margins) {
  return std::ranges::any_of(margins, [](const Margin& m) { return m.fails && !m.ok; });
}

const Margin* tightest(const std::vector<Margin>& margins) {
  const Margin* worst = nullptr;
  for (const auto& m : margins) {
    if (m.fails && (!worst || m.share > worst->share)) worst = &m;
  }
  return worst;
}

}  // namespace dld
