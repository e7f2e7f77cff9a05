#pragma once
/// The cell-free flow: run to the steady state, and its mid plane.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "fluid/lattice.hpp"
#include "measure/plane_field.hpp"
#include "output/interrupt.hpp"
#include "output/progress.hpp"
#include "parameters/text.hpp"
#include "scene/lateral_flow.hpp"
#include "scene/monitor.hpp"
#include "scene/scene.hpp"

namespace dld {

/// What became of a run to the steady state.
struct SteadyState {
  Status status = Status::undecided;
  long steps = 0;
  double residual = 1.0;  ///< relative change of the mean velocity in the last 100 steps
  FlowStatistics flow;
};

/// Smallest residual that single or double precision can show.
template <class Real>
constexpr double residual_floor() {
  return sizeof(Real) == 4 ? 1e-6 : 1e-13;
}

/// Steps until the mean velocity changes by less than the tolerance per 100 steps (twice in a row).
template <class Real>
SteadyState run_to_steady_state(Lattice<Real>& lattice, const LateralFlow& lateral, double tolerance,
                                long max_steps, Progress& progress) {
  constexpr int check_interval = 100;
  SteadyState state;
  const double goal = std::max(tolerance, residual_floor<Real>());
  double previous = 0.0, first_log = 0.0;
  int quiet = 0;
  progress.start("steady flow", 1.0);
  // An even number: populations are in place then, which moments, statistics and a checkpoint rely on.
  const long last_step = max_steps + max_steps % 2;
  while (state.steps < last_step) {
    lattice.step();
    ++state.steps;
    if (interrupted() != 0) {
      state.status = Status::interrupted;
      break;
    }
    if (state.steps % LateralFlow::interval != 0) continue;
    const bool check = state.steps % check_interval == 0;
    if (!check && !lateral.blocked()) continue;
    state.flow = lattice.statistics();
    lateral.update(lattice, state.flow.velocity);
    if (!check) continue;
    // Interpolated walls do not conserve mass exactly: hold the mean density.
    lattice.shift_density(-state.flow.mean_density_deviation);
    const double now = lateral.along(state.flow.velocity);
    if (check_fluid(lattice, state.flow, 1.0)) {
      state.status = Status::diverged;
      break;
    }
    state.residual = std::abs(now - previous) / std::max(std::abs(now), 1e-300);
    const bool level =
        !lateral.blocked() || std::abs(lateral.across(state.flow.velocity)) < 10.0 * goal * std::abs(now);
    quiet = state.residual < goal && level ? quiet + 1 : 0;
    previous = now;
    if (quiet == 2) {
      state.status = Status::converged;
      break;
    }
    if (progress.due()) {
      // The residual falls exponentially: its logarithm tells how far the run is.
      const double log_residual = std::log(std::max(state.residual, goal));
      if (first_log == 0.0) first_log = log_residual;
      const double span = first_log - std::log(goal);
      progress.update(
          span > 0 ? (first_log - log_residual) / span : 0.0,
          "step " + std::to_string(state.steps) + ", change per 100 steps " + short_number(state.residual));
    }
  }
  progress.finish(to_string(state.status));
  return state;
}

/// Velocity on the mid plane z = 0, in lattice units: from the two layers next to it and the parabola that is
/// symmetric about it. Requires lattice.even().
template <class Real>
PlaneField mid_plane(const Lattice<Real>& lattice, DistanceFunction distance) {
  const UnitCell& cell = lattice.cell();
  Eigen::ArrayXXd u = Eigen::ArrayXXd::Zero(cell.nx, cell.ny), v = u;
  SolidFlags solid = SolidFlags::Zero(cell.nx, cell.ny);
  // Layers at z = 1/2 and 3/2 (the half below is their mirror image, exact without a tilted cell).
  const bool odd = cell.height != HeightBoundary::mirror_and_wall && cell.nz % 2 == 1;
  const int near = cell.height == HeightBoundary::mirror_and_wall ? 0 : cell.nz / 2;
  for (int x = 0; x < cell.nx; ++x) {
    for (int y = 0; y < cell.ny; ++y) {
      solid(x, y) = cell.is_solid(x, y, near) ? 1 : 0;
      if (solid(x, y) != 0) continue;
      const auto first = lattice.moments(x, y, near);
      if (odd || near + 1 >= cell.nz) {
        u(x, y) = first[1];
        v(x, y) = first[2];
        continue;
      }
      const auto second = lattice.moments(x, y, near + 1);
      u(x, y) = (9.0 * first[1] - second[1]) / 8.0;
      v(x, y) = (9.0 * first[2] - second[2]) / 8.0;
    }
  }
  return {std::move(u),  std::move(v),   std::move(solid),   cell.origin_x,
          cell.origin_y, cell.row_shift, std::move(distance)};
}

}  // namespace dld
