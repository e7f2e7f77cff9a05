/// Scene `channel`: force-driven flow through a plane channel (width 0) or a rectangular duct, for
/// validation.
///
///   eta laplace u + f = 0, u = 0 on the walls; z = +- H/2, and y = +- W/2 for the duct.
///   Plane channel: u = f (H^2/4 - z^2) / (2 nu). Duct: series of White, Viscous Fluid Flow (1991), eq. 3-48.
///
/// Try: dld run params/cases/channel.json /tmp/channel.h5
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "parameters/consistency.hpp"
#include "parameters/physical.hpp"
#include "parameters/work.hpp"
#include "scene/registry.hpp"
#include "scene/setup.hpp"
#include "scene/steady_flow.hpp"

namespace dld {
namespace {

/// Velocity at (y, z) in lattice units; width 0: plane channel.
double exact_velocity(double y, double z, double width, double depth, double f_over_nu) {
  double u = 0.5 * f_over_nu * (0.25 * depth * depth - z * z);
  if (width <= 0.0) return u;
  // The plane solution minus a series in z that brings it to zero on y = +- W/2.
  constexpr int terms = 200;
  for (int k = 0; k < terms; ++k) {
    const double beta = (2 * k + 1) * std::numbers::pi / depth;
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    // cosh(beta y) / cosh(beta W/2) without overflow.
    const double ratio =
        (std::exp(beta * (std::abs(y) - 0.5 * width)) + std::exp(-beta * (std::abs(y) + 0.5 * width))) /
        (1.0 + std::exp(-beta * width));
    u -= f_over_nu * 4.0 * sign / (depth * beta * beta * beta) * ratio * std::cos(beta * z);
  }
  return u;
}

UnitCell channel_cell(const Case& c, const LatticeParameters& l, int width) {
  constexpr int margin = 4;  // solid nodes beside a duct
  UnitCell cell;
  cell.nx = 2;
  cell.ny = width > 0 ? width + margin : 4;
  cell.nz = l.nz;
  cell.height = l.half_height ? HeightBoundary::mirror_and_wall : HeightBoundary::walls;
  cell.origin_y = 0.5 - 0.5 * cell.ny;
  cell.origin_z = l.half_height ? 0.5 : 0.5 - 0.5 * l.nz;
  if (width > 0) cell.distance = [width](double, double y, double) { return 0.5 * width - std::abs(y); };
  mark_solid(cell, c.geometry.surface_nodes == "solid");
  return cell;
}

template <class Real>
Status run(const Case& c, RunContext& context) {
  const LatticeParameters l = to_lattice(c);
  const int width = static_cast<int>(std::lround(c.channel.width_um / l.um_per_lu));
  const UnitCell cell = channel_cell(c, l, width);
  Lattice<Real> lattice(cell, make_fluid_model(c));
  lattice.set_threads(context.threads);
  lattice.set_uniform_force(l.force_density, 0.0, 0.0);
  const SteadyState steady = run_to_steady_state(lattice, LateralFlow(false, l, 0.0), c.stop.steady_tolerance,
                                                 c.stop.max_steps, context.progress);
  if (steady.status == Status::interrupted) return steady.status;

  std::vector<double> ys, zs, simulated, exact;
  double largest = 0.0, centre = 0.0;
  for (int y = 0; y < cell.ny; ++y) {
    for (int z = 0; z < cell.nz; ++z) {
      if (cell.is_solid(0, y, z)) continue;
      const double py = y + cell.origin_y, pz = z + cell.origin_z;
      ys.push_back(py * l.um_per_lu);
      zs.push_back(pz * l.um_per_lu);
      simulated.push_back(lattice.moments(0, y, z)[1]);
      exact.push_back(exact_velocity(py, pz, width, l.depth, l.force_density / l.viscosity));
      largest = std::max(largest, std::abs(simulated.back() - exact.back()));
      centre = std::max(centre, exact.back());
    }
  }
  context.out.write("/profile/y_um", ys, "um", "position across the width");
  context.out.write("/profile/z_um", zs, "um", "position across the depth");
  context.out.write("/profile/velocity", simulated, "lu", "simulated velocity");
  context.out.write("/profile/exact", exact, "lu", "exact velocity");
  for (const char* dataset : {"/profile/velocity", "/profile/exact"})
    context.out.physical(dataset, "mm/s", physical_scales(c).velocity_mm_s);
  // In a plane channel the error is the same at every node: the slip of the wall.
  const double centre_line = exact_velocity(0.0, 0.0, width, l.depth, l.force_density / l.viscosity);
  context.summary["max_relative_error"] = largest / centre;
  context.summary["slip"] = (simulated.front() - exact.front()) / centre_line;
  if (const auto failure = check_fluid(lattice, steady.flow, l.um_per_lu))
    report_failure(*failure, steady.steps, context.summary);
  context.summary["mean_velocity"] = steady.flow.velocity[0];
  context.summary["steps"] = steady.steps;
  context.summary["node_updates"] = steady.steps * static_cast<long>(lattice.fluid_nodes());
  context.summary["membrane_updates"] = 0;
  return steady.status;
}

Status run_channel(const Case& c, RunContext& context) {
  return with_precision(c, [&]<class Real>() { return run<Real>(c, context); });
}

}  // namespace

Scene channel_scene() {
  return {{.name = "channel",
           .sections = {"geometry", "fluid", "stop", "channel", "output"},
           .check = check_channel,
           .margins = channel_margins,
           .work = channel_work,
           .box = channel_box},
          run_channel};
}

}  // namespace dld
