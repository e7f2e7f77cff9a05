#pragma once
/// The fluid on the lattice of one unit cell: storage, time step, moments. Populations live in one array and
/// stream in place, in pairs of a local and a streaming step (AA pattern). The local step of a plane without
/// a cell is put off until the streaming step comes by: both then find the plane in the fast cache, and the
/// memory is read once for two steps. Threads share a step by blocks of planes; every population is computed
/// by the same operations whatever their number, so results do not depend on it to the last bit.
#include <array>
#include <cstdint>
#include <vector>

#include "fluid/collision.hpp"
#include "fluid/d3q19.hpp"
#include "fluid/lattice_array.hpp"
#include "fluid/links.hpp"
#include "geometry/unit_cell.hpp"

namespace dld {

enum class CollisionModel { bgk, trt };
enum class EquilibriumModel { full, stokes };

struct FluidModel {
  CollisionModel collision = CollisionModel::trt;
  EquilibriumModel equilibrium = EquilibriumModel::stokes;
  WallModel walls = WallModel::interpolated;
  double magic_parameter = 3.0 / 16.0;
  double relaxation_time = 1.0;
  WallMotion wall_motion;
};

/// Means over the fluid nodes and the extremes of the density, at an even step.
struct FlowStatistics {
  std::array<double, 3> velocity{};  ///< mean u, lattice units
  double mean_density_deviation = 0;
  double min_density_deviation = 0, max_density_deviation = 0;
  double max_speed = 0;
};

/// Nodes with a force or a relaxation time of their own (around the cell): per x-plane a range of y, which
/// may run past ny (periodic). Empty planes have length 0.
struct ActiveRange {
  int begin = 0;   ///< first y, 0 <= begin < ny
  int length = 0;  ///< number of y values
};

template <class Real>
class Lattice {
 public:
  Lattice(const UnitCell& cell, const FluidModel& model);

  /// Body force on every fluid node, lattice units. To be changed only while even().
  void set_uniform_force(double fx, double fy, double fz) { uniform_force_ = {fx, fy, fz}; }
  std::array<double, 3> uniform_force() const { return uniform_force_; }

  /// One time step. Inside `active` the local arrays force[] (added to the uniform force) and tau are used
  /// and velocity[] is written: u = (sum c f + F/2)/rho before the collision.
  void step(const std::vector<ActiveRange>& active);
  void step() { step({}); }
  /// Threads that share a step, at most one for four planes.
  void set_threads(int threads);
  int threads() const { return static_cast<int>(blocks_.size()) - 1; }
  /// Number of steps so far is even: populations are in their natural places and moments can be read.
  bool even() const { return even_; }

  /// Density deviation and velocity at a fluid node; requires even(). The local force is included.
  std::array<double, 4> moments(int x, int y, int z) const;
  FlowStatistics statistics() const;
  /// Adds the same density to every node: interpolated walls do not conserve mass exactly.
  void shift_density(double deviation);
  /// Sets the populations to their equilibrium for a velocity field u(x, y, z) (nodes), density 1.
  template <class Function>
  void initialise(Function&& velocity);

  const LatticeLayout& layout() const { return layout_; }
  const UnitCell& cell() const { return cell_; }
  std::size_t fluid_nodes() const { return fluid_nodes_; }
  std::size_t memory_bytes() const;

  /// Local force, relaxation time, velocity and fluid mask (1 fluid, 0 solid or outside) by
  /// layout().node(...).
  std::array<LatticeArray<Real>, 3> force, velocity;
  LatticeArray<Real> relaxation_time;
  LatticeArray<Real> fluid_mask;

  /// Raw populations, for checkpoints and cached flows.
  LatticeArray<Real>& populations() { return populations_; }
  const LatticeArray<Real>& populations() const { return populations_; }

 private:
  /// Fluid nodes in a row: (x, y .. y + length - 1, z).
  struct Segment {
    int x = 0, y = 0, z = 0, length = 0;
  };
  struct Row {
    std::uint32_t first = 0, last = 0;  ///< segments of one x-plane
  };

  enum class Phase { local, streaming };
  /// Bytes of populations from which on planes are fetched ahead: fewer stay in the last-level cache.
  static constexpr std::size_t smallest_to_fetch = 8u << 20;
  static constexpr int no_plane = -1;  ///< nothing is fetched

  /// `ahead`: distance of the populations that are fetched into the cache meanwhile; 0: none.
  template <bool Stokes, bool Local>
  void collide_run(const PlacesOfNode& places, const Segment& run, std::ptrdiff_t ahead);
  /// Fetches a plane that comes later, if there is one in the box and it is not in the cache anyway.
  template <bool Stokes>
  void collide_plane(Phase phase, int x, const ActiveRange& range, int fetched_plane);
  template <bool Stokes>
  void local_step(const std::vector<ActiveRange>& active);
  template <bool Stokes>
  void streaming_step(const std::vector<ActiveRange>& active);
  template <bool Stokes>
  void sweep(int begin, int end, const std::vector<ActiveRange>& active);
  template <bool Stokes>
  void finish_local_step(int x);
  void apply(const LinkTable& table);

  UnitCell cell_;
  FluidModel model_;
  LatticeLayout layout_;
  StreamingPlaces places_;
  LinkTables links_;
  LatticeArray<Real> populations_;
  std::vector<Segment> segments_;
  std::vector<Row> planes_;
  std::array<double, 3> uniform_force_{};
  Rates<Real> uniform_rates_{};                ///< away from the cell
  std::vector<std::uint8_t> local_step_done_;  ///< per plane, between the two steps of a pair
  std::vector<int> blocks_;                    ///< first plane of every thread, and nx
  std::size_t fluid_nodes_ = 0;
  bool even_ = true;
  bool out_of_cache_ = false;  ///< planes are fetched ahead
};

template <class Real>
template <class Function>
void Lattice<Real>::initialise(Function&& velocity_at) {
  even_ = true;
  for (int x = 0; x < cell_.nx; ++x) {
    for (int y = 0; y < cell_.ny; ++y) {
      for (int z = 0; z < cell_.nz; ++z) {
        if (cell_.is_solid(x, y, z)) continue;
        const std::array<double, 3> u = velocity_at(x, y, z);
        const double u2 =
            model_.equilibrium == EquilibriumModel::stokes ? 0.0 : u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        for (int i = 0; i < d3q19::directions; ++i) {
          const auto v = d3q19::c[static_cast<std::size_t>(i)];
          const double cu = v.x * u[0] + v.y * u[1] + v.z * u[2];
          double f = 3.0 * cu;
          if (model_.equilibrium == EquilibriumModel::full) f += 4.5 * cu * cu - 1.5 * u2;
          populations_[layout_.population(i, x, y, z)] = static_cast<Real>(d3q19::weight(i) * f);
        }
      }
    }
  }
}

extern template class Lattice<float>;
extern template class Lattice<double>;

}  // namespace dld
