#pragma once
/// Cheap checks during a run: a failing run stops with the quantity, its place and the likely cure.
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "coupling/coupled_cell.hpp"
#include "fluid/lattice.hpp"
#include "geometry/pillar_array.hpp"
#include "membrane/membrane.hpp"

namespace dld {

struct Failure {
  std::string quantity;
  double value = 0, limit = 0;
  std::string place;
  std::string advice;
};

/// The members of a summary that label a diverged run.
void report_failure(const Failure& failure, long step, nlohmann::ordered_json& summary);

/// Bounds beyond which a run is no longer a simulation of anything.
struct MonitorLimits {
  double speed = 0.3;          ///< of a node of membrane or fluid, lattice units (Mach 0.5)
  double density = 0.3;        ///< |rho - 1| of a fluid node
  double volume_change = 0.1;  ///< |dV| / V0
  double area_change = 0.2;    ///< |dA| / A0
  double face_ratio = 0.02;    ///< smallest face area / reference
  double penetration = 1.0;    ///< of a node into a pillar, lattice spacings
};

/// What the checks of a coupled cell look at, lattice units.
struct CellView {
  const Membrane& membrane;
  const Eigen::MatrixX3d &positions, &velocities;  ///< nv x 3
  MembraneState state;
  double speed = 0;                      ///< of the fastest node
  double film = HUGE_VAL;                ///< smallest distance to a pillar
  const PillarArray* pillars = nullptr;  ///< for the place of the node that is in one
  double um_per_lu = 1;
};

/// The view of a cell whose membrane has this state, with the pillars that it is coupled to, if any.
template <class Real>
CellView view_of(const CoupledCell<Real>& cell, const Membrane& membrane, const MembraneState& state,
                 double um_per_lu, const PillarArray* pillars = nullptr) {
  return {.membrane = membrane,
          .positions = cell.positions(),
          .velocities = cell.velocities(),
          .state = state,
          .speed = cell.max_speed(),
          .film = pillars ? cell.film() : HUGE_VAL,
          .pillars = pillars,
          .um_per_lu = um_per_lu};
}

/// A membrane in its surroundings: speed, volume, area, smallest face, pillars.
std::optional<Failure> check_membrane(const CellView& cell, const MonitorLimits& limits = {});

/// Smallest distance between a node and the walls z = +- wall_height.
double smallest_wall_gap(const Eigen::MatrixX3d& positions, double wall_height);

/// "fluid node (x, y, z) um" with the node's place relative to the pillar of the cell and the mid plane.
std::string fluid_place(const UnitCell& cell, std::array<int, 3> node, double um_per_lu);

/// Fluid node at which quantity(moments) is largest or not a number; moments are density deviation and
/// velocity.
template <class Real, class Quantity>
std::array<int, 3> worst_node(const Lattice<Real>& lattice, Quantity&& quantity) {
  const UnitCell& cell = lattice.cell();
  std::array<int, 3> worst{};
  double largest = -1.0;
  for (int x = 0; x < cell.nx; ++x) {
    for (int y = 0; y < cell.ny; ++y) {
      for (int z = 0; z < cell.nz; ++z) {
        if (cell.is_solid(x, y, z)) continue;
        const double value = quantity(lattice.moments(x, y, z));
        if (!std::isfinite(value)) return {x, y, z};
        if (value <= largest) continue;
        largest = value;
        worst = {x, y, z};
      }
    }
  }
  return worst;
}

/// The fluid as a whole: finite, slow against the speed of sound, nearly incompressible. Needs an even step.
template <class Real>
std::optional<Failure> check_fluid(const Lattice<Real>& lattice, const FlowStatistics& flow, double um_per_lu,
                                   const MonitorLimits& limits = {}) {
  const double density = std::max(flow.max_density_deviation, -flow.min_density_deviation);
  const bool finite = std::isfinite(flow.velocity[0]) && std::isfinite(flow.mean_density_deviation);
  const bool slow = flow.max_speed < limits.speed, incompressible = density < limits.density;
  if (finite && slow && incompressible) return std::nullopt;
  const auto speed = [](const auto& m) { return std::hypot(m[1], m[2], m[3]); };
  const auto deviation = [](const auto& m) { return std::abs(m[0]); };
  const bool blame_density = finite && slow;
  const auto node = blame_density ? worst_node(lattice, deviation) : worst_node(lattice, speed);
  const std::string place = fluid_place(lattice.cell(), node, um_per_lu);
  if (!finite) {
    return Failure{"fluid is not a number", flow.velocity[0], 0, place,
                   "lower /fluid/force_density, or move /fluid/relaxation_time away from 1/2"};
  }
  if (!slow) {
    return Failure{"speed of the fluid", flow.max_speed, limits.speed, place,
                   "lower /fluid/force_density, or raise /fluid/relaxation_time"};
  }
  return Failure{"density of the fluid", density, limits.density, place,
                 "lower /fluid/force_density: density varies by about 3 f times the pitch"};
}

}  // namespace dld
