/// Solid nodes, images and wall distances of the unit cell.
#include "geometry/unit_cell.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fluid_box.hpp"

namespace dld {
namespace {

using test::BoxSize;
using test::for_fluid_nodes;
using test::unit_cell;

bool same(const NodeImage& a, const NodeImage& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.mirrored == b.mirrored;
}

TEST(UnitCell, WrapIsTheFieldIdentity) {
  const UnitCell cell = unit_cell({10, 9, 4, 0, 4, HeightBoundary::mirror_and_wall});
  for (int x = -25; x < 25; ++x) {
    for (int y = -25; y < 25; ++y) {
      const NodeImage image = cell.wrap(x, y, 2);
      EXPECT_TRUE(image.x >= 0 && image.x < 10 && image.y >= 0 && image.y < 9 && image.z == 2);
      EXPECT_FALSE(image.mirrored);
      EXPECT_TRUE(same(image, cell.wrap(x, y + 9, 2)));
      // phi(x + nx, y) = phi(x, y - d)
      EXPECT_TRUE(same(cell.wrap(x + 10, y, 2), cell.wrap(x, y - 4, 2)));
      if (x >= 0 && x < 10 && y >= 0 && y < 9) {
        EXPECT_TRUE(same(image, {x, y, 2, false}));
      }
    }
  }
}

TEST(UnitCell, HeightBoundaries) {
  const UnitCell walls = unit_cell({4, 4, 6, 0, 0, HeightBoundary::walls});
  EXPECT_EQ(walls.side(-1), HeightSide::below_wall);
  EXPECT_EQ(walls.side(0), HeightSide::inside);
  EXPECT_EQ(walls.side(5), HeightSide::inside);
  EXPECT_EQ(walls.side(6), HeightSide::above_wall);
  const UnitCell mirror = unit_cell({4, 4, 6, 0, 0, HeightBoundary::mirror_and_wall});
  EXPECT_EQ(mirror.side(-2), HeightSide::inside);
  EXPECT_EQ(mirror.side(6), HeightSide::above_wall);
  EXPECT_TRUE(same(mirror.wrap(1, 1, -1), {1, 1, 0, true}));
  EXPECT_TRUE(same(mirror.wrap(1, 1, -2), {1, 1, 1, true}));
  const UnitCell periodic = unit_cell({4, 4, 6, 0, 0, HeightBoundary::periodic});
  EXPECT_EQ(periodic.side(-3), HeightSide::inside);
  EXPECT_TRUE(same(periodic.wrap(1, 1, -1), {1, 1, 5, false}));
  EXPECT_TRUE(same(periodic.wrap(1, 1, 13), {1, 1, 1, false}));
}

/// Gauss's circle problem: 1961 lattice points with x^2 + y^2 <= 25^2, 20 of them on the circle.
TEST(UnitCell, SurfaceNodesAreAnOption) {
  UnitCell cell = unit_cell({80, 80, 1, 25.0, 15, HeightBoundary::periodic});
  EXPECT_EQ(cell.fluid_nodes(), 6400u - 1961u);
  mark_solid(cell, false);
  EXPECT_EQ(cell.fluid_nodes(), 6400u - 1941u);
}

TEST(UnitCell, CentreBetweenNodesGivesAPointSymmetricStaircase) {
  UnitCell cell = unit_cell({20, 20, 1, 7.3, 0, HeightBoundary::periodic}, -9.5, -9.5);
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y) EXPECT_EQ(cell.is_solid(x, y, 0), cell.is_solid(19 - x, 19 - y, 0));
}

/// Share of the link from (x, y) along (cx, cy) before it meets the circle of radius r about the origin.
double analytic_share(double x, double y, double cx, double cy, double r) {
  const double a = cx * cx + cy * cy, b = x * cx + y * cy, c = x * x + y * y - r * r;
  return (-b - std::sqrt(b * b - a * c)) / a;
}

TEST(UnitCell, WallFractionIsThatOfTheCircle) {
  constexpr double radius = 7.3;
  const UnitCell cell = unit_cell({24, 24, 3, radius, 5, HeightBoundary::periodic});
  int links = 0;
  for_fluid_nodes(cell, [&](int x, int y, int z) {
    for (int cx = -1; cx <= 1; ++cx) {
      for (int cy = -1; cy <= 1; ++cy) {
        for (int cz = -1; cz <= 1; ++cz) {
          const NodeImage next = cell.wrap(x + cx, y + cy, z + cz);
          if (!cell.is_solid(next.x, next.y, next.z)) continue;
          const double expected = analytic_share(x + cell.origin_x, y + cell.origin_y, cx, cy, radius);
          EXPECT_NEAR(cell.wall_fraction(x, y, z, cx, cy, cz), expected, 2e-12);
          ++links;
        }
      }
    }
  });
  EXPECT_GT(links, 500);
}

TEST(UnitCell, WallFractionOfASphereAndAtItsEnds) {
  UnitCell cell;
  cell.nx = cell.ny = cell.nz = 8;
  cell.height = HeightBoundary::periodic;
  cell.origin_x = cell.origin_y = cell.origin_z = -4;
  cell.distance = [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) - 2.25; };
  mark_solid(cell, true);
  EXPECT_NEAR(cell.wall_fraction(7, 4, 4, -1, 0, 0), 0.75, 2e-12);
  EXPECT_NEAR(cell.wall_fraction(4, 4, 1, 0, 0, 1), 0.75, 2e-12);
  cell.distance = [](double x, double, double) {
    return x;
  };  // node exactly on the surface, or its neighbour
  EXPECT_GT(cell.wall_fraction(4, 4, 4, -1, 0, 0), 0.0);
  EXPECT_NEAR(cell.wall_fraction(5, 4, 4, -1, 0, 0), 1.0, 2e-12);
}

}  // namespace
}  // namespace dld
