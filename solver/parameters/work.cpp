#include "parameters/work.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

double nodes(const LatticeBox& box) {
  return box.nx * box.ny * box.nz;
}

double open_share(const LatticeParameters& l) {
  const double area = std::numbers::pi * l.pillar_radius * l.pillar_radius;
  return std::max(0.0, 1 - area / (static_cast<double>(l.nx) * l.ny));
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
  const LatticeParameters l = to_lattice(c);
  return {static_cast<double>(l.nx), static_cast<double>(l.ny), static_cast<double>(l.nz)};
}

LatticeBox passage_box(const Case& c) {
  return streamlines_box(c);
}

LatticeBox shear_box(const Case& c) {
  const double edge = std::round(c.shear.box_um / c.fluid.lattice_spacing_um);
  return {edge, edge, edge};
}

// The boxes of stretching.cpp and channel.cpp.
LatticeBox stretching_box(const Case& c) {
  if (c.stretching.method == "static") return {};
  const double r = to_lattice(c).cell_radius;
  return {std::ceil(5.6 * r), std::ceil(4.0 * r), std::ceil(1.2 * r)};
}

LatticeBox channel_box(const Case& c) {
  const double width = std::round(c.channel.width_um / c.fluid.lattice_spacing_um);
  return {2, width + 4, static_cast<double>(to_lattice(c).nz)};
}

ExpectedWork streamlines_work(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  return of_steps(steady_steps(c), nodes(streamlines_box(c)) * open_share(l));
}

ExpectedWork passage_work(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double per_row = l.nx / estimate_flow(c).mean_speed;
  const double rows = c.stop.max_rows > 0 && c.stop.when == "rows" ? c.stop.max_rows : typical_rows;
  const double passing = std::min(rows * per_row, static_cast<double>(c.stop.max_steps));
  ExpectedWork work = of_steps(steady_steps(c) + passing, nodes(passage_box(c)) * open_share(l));
  work.steps_per_row = per_row;
  work.membrane_updates = passing * vertices(c);
  return work;
}

ExpectedWork channel_work(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double steps = settling * l.depth * l.depth / (12 * l.viscosity);
  return of_steps(std::min(steps, static_cast<double>(c.stop.max_steps)), nodes(channel_box(c)));
}

ExpectedWork shear_work(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double rate = c.shear.reynolds_number * l.viscosity / (l.cell_radius * l.cell_radius);
  ExpectedWork work = of_steps(c.shear.duration / rate, nodes(shear_box(c)));
  work.membrane_updates = work.steps * vertices(c);
  return work;
}

ExpectedWork stretching_work(const Case& c) {
  const auto forces = static_cast<double>(c.stretching.forces_pN.size());
  if (c.stretching.method == "coupled") {
    ExpectedWork work = of_steps(forces * coupled_steps_per_force, nodes(stretching_box(c)));
    work.membrane_updates = work.steps * vertices(c);
    return work;
  }
  ExpectedWork work;
  work.steps = forces * iterations_per_frequency * c.cell.mesh_frequency;
  work.membrane_updates = work.steps * vertices(c);
  work.seconds_on_one_core = work.membrane_updates / vertex_rate;
  return work;
}

double memory_bytes(const Case& c) {
  const LatticeBox box = rules_of(c.scene).box(c);
  if (nodes(box) == 0) return 1024 * 1024;
  // 19 populations (streamed in place), velocity, force, relaxation time and fluid mask; rows are filled up
  // to cache lines and have one more for their ghosts, as there is a ghost plane at either end.
  constexpr double numbers_per_node = 19 + 3 + 3 + 1 + 1, line = 16;
  const double row = (std::ceil(box.ny / line) + 1) * line;
  return (box.nx + 2) * row * box.nz * numbers_per_node * (c.fluid.precision == "single" ? 4 : 8);
}

}  // namespace dld
