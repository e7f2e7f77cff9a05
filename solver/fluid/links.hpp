#pragma once
/// Everything that happens where streaming leaves the fluid. Top and bottom walls, the mirror plane and
/// periodic layers only change the place from which the kernel reads (StreamingPlaces); the rest is a sparse
/// linear map from populations to populations: half-way and interpolated bounce-back at pillars, shifted
/// periodicity, the motion of walls. The kernel itself stays free of branches.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluid/d3q19.hpp"
#include "geometry/unit_cell.hpp"

namespace dld {

/// Places in memory of nodes (x, y, z), -1 <= x <= nx, -1 <= y <= ny, 0 <= z < nz. Fields (force, velocity)
/// have one value per node; populations stand plane by plane, within a plane direction by direction, so that
/// what a step touches at a time lies together. Rows run along y and start at multiples of 16.
struct LatticeLayout {
  int nx = 0, ny = 0, nz = 0;
  std::uint32_t row = 0;  ///< distance of rows along z
  std::uint32_t plane =
      0;  ///< values of one plane: distance of planes in fields, of directions in populations

  LatticeLayout() = default;
  LatticeLayout(int nx_, int ny_, int nz_);

  /// Place of a node in a field.
  std::uint32_t node(int x, int y, int z) const {
    return static_cast<std::uint32_t>(x + 1) * plane + static_cast<std::uint32_t>(z) * row +
           static_cast<std::uint32_t>(y + 16);
  }
  /// Place of population i of a node.
  std::uint32_t population(int i, int x, int y, int z) const {
    return node(x, y, z) + static_cast<std::uint32_t>(x + 1) * (directions - 1) * plane +
           static_cast<std::uint32_t>(i) * plane;
  }
  std::size_t field_size() const { return static_cast<std::size_t>(nx + 2) * plane + 32; }
  std::size_t populations_size() const { return static_cast<std::size_t>(nx + 2) * directions * plane + 32; }

 private:
  static constexpr std::uint32_t directions = d3q19::directions;
};

/// Places of the 19 populations of a node relative to its population 0.
using PlacesOfNode = std::array<std::ptrdiff_t, d3q19::directions>;

/// In-place ("AA", Bailey et al. 2009) scheme: the local step finds f_i of a node in its own place i and
/// leaves the post-collision f*_i in the place of the opposite direction. The streaming step finds f_i where
/// the neighbour's local step has left it and leaves f*_-i there, which is its place of arrival. For a node
/// of layer z that is streaming[z][i]: behind a wall at rest the node's own f*_-i (half-way bounce-back),
/// behind the mirror plane the mirrored direction of the neighbour that is the image.
struct StreamingPlaces {
  PlacesOfNode local;
  std::vector<PlacesOfNode> streaming;
};
StreamingPlaces streaming_places(const UnitCell& cell, const LatticeLayout& layout);

/// half_way: bounce-back, the wall half way along each link. interpolated: linear interpolated bounce-back
/// (Bouzidi, Firdaouss and Lallemand 2001). central_linear: central linear interpolation (Ginzburg, Verhaeghe
/// and d'Humieres 2008). The latter two are exact for linear flow wherever the wall cuts the link; beyond
/// that the interpolated wall moves with the relaxation time, the central one does not (at a fixed magic
/// parameter).
enum class WallModel { half_way, interpolated, central_linear };

/// Velocity of the top and bottom walls along x (Couette flow), lattice units.
struct WallMotion {
  double below = 0.0, above = 0.0;
};

/// destination[k] = source[k], k = 0 .. length - 1.
struct CopyRun {
  std::uint32_t destination, source, length;
};

/// destination = source, in each of the layers above one another: copies that found no neighbours to run
/// with. Places of the next layer are one row further.
struct Copy {
  std::uint32_t destination, source;
  std::uint32_t layers = 1;
};

/// destination = sum of weight * source, in each of the layers above one another: a pillar cuts the links of
/// all layers alike.
struct Combination {
  std::uint32_t destination;
  std::array<std::uint32_t, 3> source;
  std::array<double, 3> weight;
  std::uint32_t layers = 1;
};

/// destination += constant: what a moving wall adds to a population that comes back from it.
struct Addition {
  std::uint32_t destination;
  double constant;
};

/// Additions come last: combinations look at what went to the wall.
struct LinkTable {
  std::vector<CopyRun> runs;
  std::vector<Copy> copies;
  std::vector<Combination> combinations;
  std::vector<Addition> additions;
};

/// Tables of the in-place scheme, one per plane x. `before[x]` fills the places outside the fluid that the
/// streaming step of plane x reads; it needs the local step of the planes x - 1 .. x + 1 and must run before
/// the streaming step of plane x - 1, which overwrites what interpolated walls look at. `after[x]` brings
/// home what the streaming step of the planes x - 1 .. x + 1 has written outside the fluid; it must not run
/// ahead of `before[x + 1]`, nor plane 0 ahead of the last plane, its periodic neighbour.
struct LinkTables {
  std::vector<LinkTable> before, after;
};

LinkTables build_links(const UnitCell& cell, const LatticeLayout& layout, WallModel model,
                       const WallMotion& motion);

}  // namespace dld
