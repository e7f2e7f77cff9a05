/// Pillar shapes and the distances in the row-shifted array.
#include "geometry/pillar.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>

#include "geometry/circle.hpp"
#include "geometry/no_pillar.hpp"
#include "geometry/pillar_array.hpp"
#include "geometry/pillar_surface.hpp"

namespace dld {
namespace {

constexpr double pitch = 80, radius = 25, shift = 15;

PillarArray circles(double r) {
  return {std::make_shared<const Circle>(r), pitch, pitch, shift};
}

/// Distance to the nearest of many pillars, without any reduction.
double brute_force(double x, double y, double r) {
  double nearest = 1e300;
  for (int n = -6; n <= 6; ++n)
    for (int m = -9; m <= 9; ++m)
      nearest = std::min(nearest, std::hypot(x - n * pitch, y - m * pitch - n * shift) - r);
  return nearest;
}

TEST(Pillar, RegistryMakesWhatItNames) {
  for (const auto& name : pillar_shape_names()) EXPECT_FALSE(pillar_doc(name).empty()) << name;
  EXPECT_NE(make_pillar({"circle", {{"radius_um", {1.0}}}}), nullptr);
  EXPECT_THROW(make_pillar({"hexagon of cheese", {}}), std::invalid_argument);
  EXPECT_THROW(make_pillar({"circle", {}}), std::invalid_argument);
}

TEST(Pillar, CircleDistance) {
  const Circle circle(radius);
  EXPECT_DOUBLE_EQ(circle.signed_distance(0, 0), -radius);
  EXPECT_DOUBLE_EQ(circle.signed_distance(15, 20), 0);
  EXPECT_DOUBLE_EQ(circle.signed_distance(-30, 40), 25);
  EXPECT_GE(circle.bounding_radius(), radius);
}

TEST(PillarArray, DistanceIsThatToTheNearestOfAllImages) {
  for (const double r : {10.0, 25.0, 38.0}) {
    const PillarArray array = circles(r);
    for (double x = -170; x < 170; x += 3.7)
      for (double y = -170; y < 170; y += 4.1)
        ASSERT_NEAR(array.signed_distance(x, y), brute_force(x, y, r), 1e-11) << x << ", " << y;
  }
}

TEST(PillarArray, RepeatsWithTheArray) {
  const PillarArray array = circles(radius);
  for (double x = -30; x < 50; x += 7.3) {
    for (double y = -40; y < 40; y += 5.9) {
      EXPECT_NEAR(array.signed_distance(x + 3 * pitch, y + 3 * shift), array.signed_distance(x, y), 1e-11);
      EXPECT_NEAR(array.signed_distance(x, y - 2 * pitch), array.signed_distance(x, y), 1e-11);
    }
  }
}

TEST(PillarArray, ReduceNamesTheColumnAndTheLane) {
  const ReducedPoint p = circles(radius).reduce(2 * pitch + 1.5, -pitch + 2 * shift - 3.25);
  EXPECT_NEAR(p.x, 1.5, 1e-12);
  EXPECT_NEAR(p.y, -3.25, 1e-12);
  EXPECT_EQ(p.column, 2);
  EXPECT_EQ(p.lane, -1);
}

TEST(PillarArray, NormalsPointIntoTheFluid) {
  const PillarArray array = circles(radius);
  for (double angle = 0; angle < 6.3; angle += 0.1) {
    const auto n = array.normal(pitch + 26 * std::cos(angle), shift + 26 * std::sin(angle));
    EXPECT_NEAR(n[0], std::cos(angle), 1e-8);
    EXPECT_NEAR(n[1], std::sin(angle), 1e-8);
  }
}

TEST(PillarArray, NoPillarIsInfinitelyFar) {
  const PillarArray none(std::make_shared<const NoPillar>(), pitch, pitch, shift);
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(circles(radius).empty());
  EXPECT_GT(none.signed_distance(3, 4), 1e100);
  EXPECT_EQ(none.normal(3, 4)[0], 0.0);
}

// Every vertex of the wall is on the pillar, every edge of its triangles belongs to two of them but for the
// rims, and the area is that of the cylinder.
TEST(PillarWall, IsTheWallOfTheCylinder) {
  const double half_height = 6;
  const Surface wall = pillar_wall(Circle(radius), half_height);
  for (const auto& v : wall.vertices.rowwise()) {
    EXPECT_NEAR(std::hypot(v(0), v(1)), radius, 1e-9);
    EXPECT_EQ(std::abs(v(2)), half_height);
  }
  double area = 0;
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : wall.triangles.rowwise()) {
    const Eigen::RowVector3d a = wall.vertices.row(t(1)) - wall.vertices.row(t(0));
    const Eigen::RowVector3d b = wall.vertices.row(t(2)) - wall.vertices.row(t(0));
    area += 0.5 * a.cross(b).norm();
    for (int k = 0; k < 3; ++k) ++edges[std::minmax<int>({t(k), t((k + 1) % 3)})];
  }
  EXPECT_NEAR(area, 2 * std::numbers::pi * radius * 2 * half_height, 1e-3 * area);
  for (const auto& [edge, count] : edges) {
    const bool rim = wall.vertices(edge.first, 2) == wall.vertices(edge.second, 2);
    EXPECT_EQ(count, rim ? 1 : 2);
  }
  EXPECT_EQ(pillar_wall(NoPillar(), half_height).vertices.rows(), 0);
}

}  // namespace
}  // namespace dld
