/// Drag of the square array of cylinders under refinement: interpolated walls against the staircase.
#include <gtest/gtest.h>

#include "support/convergence.hpp"
#include "support/periodic_drag.hpp"

namespace dld {
namespace {

constexpr double radius_over_pitch = 0.2053;  // no node on the surface at any level

double drag_error(int n, WallModel walls, double offset) {
  FluidModel model;
  model.walls = walls;
  const double r = radius_over_pitch * n, c = std::numbers::pi * radius_over_pitch * radius_over_pitch;
  return test::measured_drag(test::cylinder_cell(n, r, offset), model, 1e-9) / test::cylinder_drag(c) - 1;
}

TEST(CylinderArrayConvergence, InterpolatedWallsAreOfSecondOrder) {
  std::vector<test::Level> levels;
  for (const int n : {12, 24, 48}) levels.push_back({double(n), drag_error(n, WallModel::interpolated, 0.0)});
  const auto orders = test::print_orders("cylinder drag, interpolated walls, against the pitch", levels);
  EXPECT_LT(std::abs(levels.back().error), 5e-3);
  EXPECT_GT(std::log(std::abs(levels[0].error / levels[2].error)) / std::log(4.0), 1.6);
}

/// The centre moved by a part of the spacing: the drag of interpolated walls hardly notices, the staircase
/// does.
TEST(CylinderArrayConvergence, PlaceOnTheLatticeMattersLessWithInterpolatedWalls) {
  const auto spread = [](WallModel walls) {
    double low = 1e300, high = -1e300;
    for (const double offset : {0.0, 0.25, 0.5}) {
      const double error = drag_error(24, walls, offset);
      low = std::min(low, error);
      high = std::max(high, error);
    }
    return high - low;
  };
  const double interpolated = spread(WallModel::interpolated), staircase = spread(WallModel::half_way);
  std::printf("spread of the drag over the centre's place: interpolated %.2e, half-way %.2e\n", interpolated,
              staircase);
  EXPECT_LT(interpolated, 0.01);
  EXPECT_LT(interpolated, 0.5 * staircase);
}

}  // namespace
}  // namespace dld
