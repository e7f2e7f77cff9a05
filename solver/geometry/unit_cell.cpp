#include "geometry/unit_cell.hpp"

#include <algorithm>
#include <cmath>

namespace dld {
namespace {

int floor_mod(int a, int n) {
  const int r = a % n;
  return r < 0 ? r + n : r;
}

int floor_div(int a, int n) {
  return (a - floor_mod(a, n)) / n;
}

}  // namespace

HeightSide UnitCell::side(int z) const {
  if (height == HeightBoundary::periodic) return HeightSide::inside;
  if (z >= nz) return HeightSide::above_wall;
  if (z < 0 && height == HeightBoundary::walls) return HeightSide::below_wall;
  return HeightSide::inside;
}

NodeImage UnitCell::wrap(int x, int y, int z) const {
  NodeImage image;
  // phi(x + n nx, y) = phi(x, y - n d): shift before the y wrap.
  const int n = floor_div(x, nx);
  image.x = x - n * nx;
  image.y = floor_mod(y - n * row_shift, ny);
  image.z = z;
  if (height == HeightBoundary::periodic) {
    image.z = floor_mod(z, nz);
  } else if (z < 0 && height == HeightBoundary::mirror_and_wall) {
    image.z = -1 - z;
    image.mirrored = true;
  }
  return image;
}

double UnitCell::wall_fraction(int x, int y, int z, int cx, int cy, int cz) const {
  const auto at = [&](double q) {
    return distance(x + origin_x + q * cx, y + origin_y + q * cy, z + origin_z + q * cz);
  };
  // The node is fluid, its neighbour solid: the distance changes sign on the link. Bisection to 1e-12 is
  // cheap (done once) and holds for any shape.
  double fluid = 0.0, wall = 1.0;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (fluid + wall);
    (at(middle) > 0.0 ? fluid : wall) = middle;
  }
  return std::clamp(0.5 * (fluid + wall), 1e-6, 1.0);
}

std::size_t UnitCell::fluid_nodes() const {
  return static_cast<std::size_t>(std::count(solid.begin(), solid.end(), std::uint8_t{0}));
}

void mark_solid(UnitCell& cell, bool surface_is_solid) {
  cell.solid.assign(static_cast<std::size_t>(cell.nx) * static_cast<std::size_t>(cell.ny) *
                        static_cast<std::size_t>(cell.nz),
                    0);
  if (!cell.distance) return;
  constexpr double rounding = 1e-9;  // a node this near counts as lying exactly on the surface
  const double limit = surface_is_solid ? rounding : -rounding;
  for (int x = 0; x < cell.nx; ++x) {
    for (int y = 0; y < cell.ny; ++y) {
      for (int z = 0; z < cell.nz; ++z) {
        const double d = cell.distance(x + cell.origin_x, y + cell.origin_y, z + cell.origin_z);
        cell.solid[cell.index(x, y, z)] = d <= limit ? 1 : 0;
      }
    }
  }
}

}  // namespace dld
