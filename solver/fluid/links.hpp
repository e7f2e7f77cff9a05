#pragma once
/// Everything that happens where streaming leaves the fluid, written once as a sparse linear map from
/// populations to populations: half-way and interpolated bounce-back, moving walls, mirror plane, shifted
/// periodicity. The kernel itself stays free of branches.
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/unit_cell.hpp"

namespace dld {

/// Place of populations in memory: population i of raw node (x, y, z), -1 <= x <= nx and so on, at
/// i * stride + node(x, y, z). Rows run along y and start at multiples of 16.
struct LatticeLayout {
  int nx = 0, ny = 0, nz = 0;
  std::uint32_t row = 0;     ///< distance of rows along z
  std::uint32_t column = 0;  ///< distance of planes along x
  std::uint32_t stride = 0;  ///< distance of directions

  LatticeLayout() = default;
  LatticeLayout(int nx_, int ny_, int nz_);
  std::uint32_t node(int x, int y, int z) const {
    return static_cast<std::uint32_t>(x + 1) * column + static_cast<std::uint32_t>(z + 1) * row +
           static_cast<std::uint32_t>(y + 16);
  }
  std::uint32_t slot(int direction, std::uint32_t node_index) const {
    return static_cast<std::uint32_t>(direction) * stride + node_index;
  }
};

enum class WallModel { half_way, interpolated };

/// Velocity of the top and bottom walls along x (Couette flow), lattice units.
struct WallMotion {
  double below = 0.0, above = 0.0;
};

/// destination[k] = source[k] + constant, k = 0 .. length - 1.
struct CopyRun {
  std::uint32_t destination, source, length;
  double constant;
};

/// destination = source: copies that found no neighbours to run with.
struct Copy {
  std::uint32_t destination, source;
};

/// destination = sum of weight * source.
struct Combination {
  std::uint32_t destination;
  std::array<std::uint32_t, 2> source;
  std::array<double, 2> weight;
};

struct LinkTable {
  std::vector<CopyRun> runs;
  std::vector<Copy> copies;
  std::vector<Combination> combinations;
};

/// Tables of the in-place ("AA", Bailey et al. 2009) scheme: `before` runs between the local and the
/// streaming step and fills the slots that the streaming step reads outside the fluid; `after` runs behind
/// the streaming step and brings home what it has written there.
struct LinkTables {
  LinkTable before, after;
};

LinkTables build_links(const UnitCell& cell, const LatticeLayout& layout, WallModel model,
                       const WallMotion& motion);

}  // namespace dld
