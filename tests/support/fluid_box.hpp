#pragma once
/// Small fluid boxes for the tests: one pillar or none, any height boundary, any place of the origin.
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "fluid/lattice.hpp"
#include "geometry/circle.hpp"
#include "geometry/no_pillar.hpp"
#include "geometry/pillar_array.hpp"
#include "geometry/unit_cell.hpp"

namespace dld::test {

/// What a box is made of, lattice units. radius 0: no pillar.
struct BoxSize {
  int nx = 0, ny = 0, nz = 0;
  double radius = 0;
  int row_shift = 0;
  HeightBoundary height = HeightBoundary::walls;
};

/// Coordinate of layer z = 0, so that the mid plane (or the mirror plane) is at z = 0.
inline double first_layer(const BoxSize& size) {
  return size.height == HeightBoundary::mirror_and_wall ? 0.5 : 0.5 - 0.5 * size.nz;
}

inline std::shared_ptr<const PillarArray> pillar_array(const BoxSize& size) {
  std::shared_ptr<const PillarShape> shape = std::make_shared<const NoPillar>();
  if (size.radius > 0) shape = std::make_shared<const Circle>(size.radius);
  return std::make_shared<const PillarArray>(shape, size.nx, size.ny, size.row_shift);
}

/// Unit cell whose node (0, 0, .) stands at (origin_x, origin_y) relative to the pillar's centre.
inline UnitCell unit_cell(const BoxSize& size, double origin_x, double origin_y) {
  UnitCell cell;
  cell.nx = size.nx;
  cell.ny = size.ny;
  cell.nz = size.nz;
  cell.row_shift = size.row_shift;
  cell.height = size.height;
  cell.origin_x = origin_x;
  cell.origin_y = origin_y;
  cell.origin_z = first_layer(size);
  cell.distance = [array = pillar_array(size)](double x, double y, double) {
    return array->signed_distance(x, y);
  };
  mark_solid(cell, true);
  return cell;
}

/// The pillar's centre on the node in the middle of the cell.
inline UnitCell unit_cell(const BoxSize& size) {
  return unit_cell(size, -(size.nx / 2), -(size.ny / 2));
}

/// Gives the nodes of a box without pillar that lie below the height z the relaxation time tau.
template <class Real>
void set_relaxation_time_below(Lattice<Real>& lattice, const BoxSize& size, double z, double tau) {
  for (int k = 0; k < size.nz && first_layer(size) + k < z; ++k) {
    for (int i = 0; i < size.nx; ++i) {
      for (int j = 0; j < size.ny; ++j)
        lattice.relaxation_time[lattice.layout().node(i, j, k)] = static_cast<Real>(tau);
    }
  }
}

/// Calls function(x, y, z) at every fluid node.
template <class Function>
void for_fluid_nodes(const UnitCell& cell, Function&& function) {
  for (int x = 0; x < cell.nx; ++x)
    for (int y = 0; y < cell.ny; ++y)
      for (int z = 0; z < cell.nz; ++z)
        if (!cell.is_solid(x, y, z)) function(x, y, z);
}

/// Steps until the mean velocity along x changes by less than `tolerance` (relative) per 100 steps; returns
/// the mean velocity over the fluid nodes. The mean density is held at 1.
template <class Real>
std::array<double, 3> steady_mean_velocity(Lattice<Real>& lattice, double tolerance,
                                           long max_steps = 200000) {
  double previous = 0;
  std::array<double, 3> mean{};
  for (long step = 0; step < max_steps; step += 100) {
    for (int k = 0; k < 100; ++k) lattice.step();
    const FlowStatistics flow = lattice.statistics();
    lattice.shift_density(-flow.mean_density_deviation);
    mean = flow.velocity;
    if (std::abs(mean[0] - previous) <= tolerance * std::abs(mean[0])) return mean;
    previous = mean[0];
  }
  return {NAN, NAN, NAN};
}

/// Uniform numbers in -1 .. 1, the same in every run.
class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : generator_(seed) {}
  double operator()() { return distribution_(generator_); }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> distribution_{-1.0, 1.0};
};

}  // namespace dld::test
