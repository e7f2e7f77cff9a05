#pragma once
/// Drag on periodic arrays: square arrays of cylinders, simple cubic arrays of spheres.
///
/// The body force f on the fluid stands for the mean pressure gradient, so the drag on one obstacle,
/// buoyancy included, is f times the volume of the cell; U is the mean over the whole cell (superficial).
#include <numbers>

#include "support/duct.hpp"
#include "support/fluid_box.hpp"

namespace dld::test {

/// Sangani and Acrivos 1982: F / (mu U) per length, c = area fraction, c below about 0.3.
inline double cylinder_drag(double c) {
  return 4 * std::numbers::pi / (std::log(1 / std::sqrt(c)) - 0.738 + c - 0.887 * c * c + 2.038 * c * c * c);
}

/// Hasimoto 1959: K in F = 6 pi mu a U K, c = volume fraction (dilute).
inline double sphere_drag_factor(double c) {
  return 1 / (1 - 1.7601 * std::cbrt(c) + c - 1.5593 * c * c);
}

/// F / (mu U) of the lattice, run to its steady state. nz = 1: per length of the cylinder.
inline double measured_drag(const UnitCell& cell, const FluidModel& model, double tolerance) {
  Lattice<double> lattice(cell, model);
  constexpr double force = 1e-6;
  lattice.set_uniform_force(force, 0, 0);
  const double mean = steady_mean_velocity(lattice, tolerance)[0];
  const double volume = static_cast<double>(cell.nx) * cell.ny * cell.nz;
  const double superficial = mean * static_cast<double>(lattice.fluid_nodes()) / volume;
  return force * volume / (viscosity(model) * superficial);
}

/// Square array: side n, cylinder of radius r along z. The centre is off the nodes by (offset, offset).
inline UnitCell cylinder_cell(int n, double r, double offset = 0) {
  return unit_cell({n, n, 1, r, 0, HeightBoundary::periodic}, -(n / 2) + offset, -(n / 2) + offset);
}

inline UnitCell sphere_cell(int n, double r, double offset = 0) {
  UnitCell cell;
  cell.nx = cell.ny = cell.nz = n;
  cell.height = HeightBoundary::periodic;
  cell.origin_x = cell.origin_y = cell.origin_z = offset - n / 2;
  cell.distance = [r](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) - r; };
  mark_solid(cell, true);
  return cell;
}

}  // namespace dld::test
