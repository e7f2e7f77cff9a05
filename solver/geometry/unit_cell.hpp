#pragma once
/// The lattice of one unit cell: which nodes are solid, where their links meet the wall, and how a raw
/// node coordinate outside the cell maps to its image inside (shifted periodicity, mirror plane).
#include <cstdint>
#include <functional>
#include <vector>

namespace dld {

/// What lies beyond the first and the last layer in z.
enum class HeightBoundary { walls, mirror_and_wall, periodic };

/// Image of a raw node inside the unit cell.
struct NodeImage {
  int x = 0, y = 0, z = 0;
  bool mirrored = false;  ///< z-components of vectors change sign
};

/// A node beyond a top or bottom wall.
enum class HeightSide { inside, below_wall, above_wall };

/// Nodes (x, y, z), 0 <= x < nx and so on. Physical coordinates have their origin at the pillar's centre
/// on the mid plane: node (x, y, z) stands at (x + origin_x, y + origin_y, z + origin_z).
struct UnitCell {
  int nx = 0, ny = 0, nz = 0;
  int row_shift = 0;  ///< field identity phi(x + nx, y) = phi(x, y - row_shift)
  HeightBoundary height = HeightBoundary::walls;
  double origin_x = 0, origin_y = 0, origin_z = 0;
  std::vector<std::uint8_t> solid;  ///< nx * ny * nz, 1 = solid; index (x * ny + y) * nz + z

  /// Signed distance of the solid at a physical point (negative inside), used for the wall's place on a link.
  std::function<double(double, double, double)> distance;

  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nz) +
           static_cast<std::size_t>(z);
  }
  bool is_solid(int x, int y, int z) const { return solid[index(x, y, z)] != 0; }

  /// Side of the top and bottom walls on which layer z lies.
  HeightSide side(int z) const;
  /// Image of a raw node between the walls (side(z) == inside).
  NodeImage wrap(int x, int y, int z) const;
  /// Share q in (0, 1] of the link from fluid node (x, y, z) along (cx, cy, cz) that lies in the fluid.
  double wall_fraction(int x, int y, int z, int cx, int cy, int cz) const;
  /// Number of fluid nodes.
  std::size_t fluid_nodes() const;
};

/// Marks the nodes whose distance is negative (or zero, if surface nodes are solid).
void mark_solid(UnitCell& cell, bool surface_is_solid);

}  // namespace dld
