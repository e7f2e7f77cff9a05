/// Drag of the square array of cylinders under refinement: interpolated walls against the staircase. The
/// error depends on where the circle cuts the links, so that an order shows only in the mean over places of
/// the centre.
#include <gtest/gtest.h>

#include "support/convergence.hpp"
#include "support/periodic_drag.hpp"

namespace dld {
namespace {

constexpr double radius_over_pitch = 0.2053;  // no node on the surface at any level

double cylinder_drag(int n, WallModel walls, double offset, double relaxation_time = 1.0) {
  FluidModel model;
  model.walls = walls;
  model.relaxation_time = relaxation_time;
  return test::measured_drag(test::cylinder_cell(n, radius_over_pitch * n, offset), model, 1e-9);
}

/// Relative errors over places of the centre: root mean square, and largest less smallest.
struct Errors {
  double rms = 0, spread = 0;
};

Errors drag_errors(int n, WallModel walls) {
  const double exact = test::cylinder_drag(std::numbers::pi * radius_over_pitch * radius_over_pitch);
  Errors e;
  double low = 1e300, high = -1e300;
  constexpr int places = 6;
  for (int k = 0; k < places; ++k) {
    const double error = cylinder_drag(n, walls, 0.1 * k) / exact - 1;
    e.rms += error * error / places;
    low = std::min(low, error);
    high = std::max(high, error);
  }
  return {std::sqrt(e.rms), high - low};
}

TEST(CylinderArrayConvergence, InterpolatedWallsAreOfSecondOrder) {
  std::vector<test::Level> levels;
  for (const int n : {15, 30, 60}) levels.push_back({double(n), drag_errors(n, WallModel::interpolated).rms});
  const auto orders =
      test::print_orders("cylinder drag, interpolated walls, rms error against the pitch", levels);
  EXPECT_LT(levels.back().error, 3e-3);
  for (const double order : orders) EXPECT_GT(order, 1.4);
  EXPECT_GT(0.5 * (orders[0] + orders[1]), 1.7);
}

TEST(CylinderArrayConvergence, StaircaseIsWorseAndDependsOnThePlace) {
  const Errors interpolated = drag_errors(40, WallModel::interpolated),
               staircase = drag_errors(40, WallModel::half_way);
  std::printf("n = 40: rms and spread over places, interpolated %.2e %.2e, half-way %.2e %.2e\n",
              interpolated.rms, interpolated.spread, staircase.rms, staircase.spread);
  EXPECT_LT(interpolated.spread, 0.015);
  EXPECT_LT(interpolated.rms, 0.5 * staircase.rms);
  EXPECT_LT(interpolated.spread, 0.5 * staircase.spread);
}

/// At fixed Lambda the steady Stokes flow between half-way walls does not depend on the viscosity.
TEST(CylinderArrayConvergence, HalfWayDragDoesNotDependOnTheRelaxationTime) {
  const double reference = cylinder_drag(20, WallModel::half_way, 0.0);
  for (const double tau : {0.7, 2.0}) {
    EXPECT_NEAR(cylinder_drag(20, WallModel::half_way, 0.0, tau) / reference, 1, 1e-7) << tau;
  }
}

/// Turning the force by a right angle turns the flow.
TEST(CylinderArrayConvergence, SquareArrayIsIsotropic) {
  Lattice<double> along_x(test::cylinder_cell(20, 4.1), FluidModel{}),
      along_y(test::cylinder_cell(20, 4.1), FluidModel{});
  along_x.set_uniform_force(1e-6, 0, 0);
  along_y.set_uniform_force(0, 1e-6, 0);
  for (int k = 0; k < 1000; ++k) along_x.step(), along_y.step();
  const auto ux = along_x.statistics().velocity, uy = along_y.statistics().velocity;
  EXPECT_NEAR(ux[0] / uy[1], 1, 1e-12);
  EXPECT_NEAR(ux[1] / ux[0], 0, 1e-12);
}

}  // namespace
}  // namespace dld
