#pragma once
/// Force-driven flow through plane channels and rectangular ducts: boxes and exact solutions.
///   nu laplace u + f = 0, u = 0 on z = +- H/2 (and on y = +- W/2).
#include <cmath>
#include <numbers>

#include "fluid/lattice.hpp"
#include "support/fluid_box.hpp"

namespace dld::test {

/// Velocity of the plane channel, lattice units.
inline double plane_velocity(double z, double height, double f_over_nu) {
  return 0.5 * f_over_nu * (0.25 * height * height - z * z);
}

/// Velocity of the duct (double Fourier series).
inline double duct_velocity(double y, double z, double width, double height, double f_over_nu) {
  constexpr double pi = std::numbers::pi;
  double u = 0;
  for (int m = 1; m < 160; m += 2) {
    for (int n = 1; n < 160; n += 2) {
      const double sign = (m + n) / 2 % 2 == 1 ? 1.0 : -1.0;
      const double k2 = pi * pi * (m * m / (width * width) + n * n / (height * height));
      u += sign * 16 / (pi * pi * m * n) * std::cos(m * pi * y / width) * std::cos(n * pi * z / height) / k2;
    }
  }
  return u * f_over_nu;
}

/// Box for a channel (width 0) or a duct with solid nodes beside it.
inline UnitCell duct_cell(int width, int height, bool mirror = false) {
  UnitCell cell;
  cell.nx = 2;
  cell.ny = width > 0 ? width + 2 : 2;
  cell.nz = mirror ? height / 2 : height;
  cell.height = mirror ? HeightBoundary::mirror_and_wall : HeightBoundary::walls;
  cell.origin_y = 0.5 - 0.5 * cell.ny;
  cell.origin_z = mirror ? 0.5 : 0.5 - 0.5 * height;
  if (width > 0) cell.distance = [width](double, double y, double) { return 0.5 * width - std::abs(y); };
  mark_solid(cell, true);
  return cell;
}

/// Steady lattice with unit centre-line velocity scale: f = force.
inline Lattice<double> steady_duct(const UnitCell& cell, const FluidModel& model, double force,
                                   double tolerance) {
  Lattice<double> lattice(cell, model);
  lattice.set_uniform_force(force, 0, 0);
  steady_mean_velocity(lattice, tolerance);
  return lattice;
}

inline double viscosity(const FluidModel& model) {
  return (model.relaxation_time - 0.5) / 3;
}

}  // namespace dld::test
