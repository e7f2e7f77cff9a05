#include "parameters/work.hpp"

#include <algorithm>
#include <cmath>

#include "parameters/cell_surface.hpp"
#include "parameters/flow_estimate.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

// Measured on a core with AVX-512, on the paper's lattice: node updates per second, the cell included, and
// vertices per second of the minimiser.
constexpr double node_rate = 150e6, vertex_rate = 5e6;
// Pillar lines that a typical passage crosses before its class is proved.
constexpr double typical_rows = 10;
// Flow without a cell: steps to the steady state in units of mobility / viscosity, from 19 (shallow) to 28
// (deep).
constexpr double settling = 28;
// Median of the tweezer: iterations of the minimiser per force, over the mesh frequency; and steps through
// the fluid per force.
constexpr double iterations_per_frequency = 36, coupled_steps_per_force = 9000;

double vertices(const Case& c) {
  return 10.0 * c.cell.mesh_frequency * c.cell.mesh_frequency + 2;
}

// Share of the unit cell that is not pillar.
double open_share(const Case& c) {
  const PillarArray pillars = device_um(c).pillars();
  return device_um(c).open_area() / (pillars.pitch_x() * pillars.pitch_y());
}

// Steps until a flow without a cell is steady, at the most those that the case allows.
double steady_steps(const Case& c) {
  return std::min(settling * estimate_flow(c).settling_time, static_cast<double>(c.stop.max_steps));
}

ExpectedWork of_steps(double steps, double fluid_nodes) {
  ExpectedWork work;
  work.steps = steps;
  work.node_updates = steps * fluid_nodes;
  work.seconds_on_one_core = work.node_updates / node_rate;
  return work;
}

}  // namespace

LatticeBox streamlines_box(const Case& c) {
  const double dx = c.fluid.lattice_spacing_um, halves = c.geometry.height == "half" ? 0.5 : 1.0;
  return {c.geometry.pitch_um / dx, c.geometry.pitch_across_um() / dx, halves * c.geometry.depth_um / dx};
}

LatticeBox passage_box(const Case& c) {
  return streamlines_box(c);
}

LatticeBox shear_box(const Case& c) {
  const double edge = c.shear.box_um / c.fluid.lattice_spacing_um;
  return {edge, edge, edge};
}

// The boxes of units.cpp and channel.cpp.
LatticeBox stretching_box(const Case& c) {
  if (c.stretching.method == "static") return {};
  const double r = half_box_um(c.cell) / c.fluid.lattice_spacing_um;
  return {std::ceil(5.6 * r), std::ceil(4.0 * r), std::ceil(1.2 * r)};
}

LatticeBox channel_box(const Case& c) {
  return {2, c.channel.width_um / c.fluid.lattice_spacing_um + 4, streamlines_box(c).nz};
}

ExpectedWork streamlines_work(const Case& c) {
  return of_steps(steady_steps(c), streamlines_box(c).nodes() * open_share(c));
}

ExpectedWork passage_work(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double per_row = l.nx / estimate_flow(c).mean_speed;
  const double rows = c.stop.max_rows > 0 && c.stop.when == "rows" ? c.stop.max_rows : typical_rows;
  const double passing = std::min(rows * per_row, static_cast<double>(c.stop.max_steps));
  ExpectedWork work = of_steps(steady_steps(c) + passing, passage_box(c).nodes() * open_share(c));
  work.steps_per_row = per_row;
  work.membrane_updates = passing * vertices(c);
  return work;
}

ExpectedWork channel_work(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double steps = settling * l.depth * l.depth / (12 * l.viscosity);
  return of_steps(std::min(steps, static_cast<double>(c.stop.max_steps)), channel_box(c).nodes());
}

ExpectedWork shear_work(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double rate = c.shear.reynolds_number * l.viscosity / (l.cell_radius * l.cell_radius);
  ExpectedWork work = of_steps(c.shear.duration / rate, shear_box(c).nodes());
  work.membrane_updates = work.steps * vertices(c);
  return work;
}

ExpectedWork stretching_work(const Case& c) {
  const auto forces = static_cast<double>(c.stretching.forces_pN.size());
  if (c.stretching.method == "coupled") {
    ExpectedWork work = of_steps(forces * coupled_steps_per_force, stretching_box(c).nodes());
    work.membrane_updates = work.steps * vertices(c);
    return work;
  }
  ExpectedWork work;
  work.steps = forces * iterations_per_frequency * c.cell.mesh_frequency;
  work.membrane_updates = work.steps * vertices(c);
  work.seconds_on_one_core = work.membrane_updates / vertex_rate;
  return work;
}

}  // namespace dld
