/// Pillar shapes and the distances in the row-shifted array.
#include "geometry/pillar.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/circle.hpp"
#include "geometry/no_pillar.hpp"
#include "geometry/pillar_array.hpp"

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

}  // namespace
}  // namespace dld
