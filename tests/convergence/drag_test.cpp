/// Drag of the square array of cylinders under refinement: interpolated walls against the staircase. The
/// error depends on where the circle cuts the links, so that an order shows only in the mean over places of
/// the centre.
#include <gtest/gtest.h>

#include "support/convergence.hpp"
#include "support/periodic_drag.hpp"

namespace dld {
namespace {

// Area fraction 0.2, a value of table 1 of Sangani and Acrivos 1982; no node on the surface at any level.
const double radius_over_pitch = std::sqrt(0.2 / std::numbers::pi);
constexpr double exact_drag = 51.53;

double cylinder_drag(int n, WallModel walls, double offset) {
  FluidModel model;
  model.walls = walls;
  model.relaxation_time = 1.0;
  return test::measured_drag(test::cylinder_cell(n, radius_over_pitch * n, offset), model, 1e-9);
}

/// Relative errors over places of the centre: root mean square, and largest less smallest.
struct Errors {
  double rms = 0, spread = 0;
};

Errors drag_errors(int n, WallModel walls) {
  Errors e;
  double low = 1e300, high = -1e300;
  constexpr int places = 6;
  for (int k = 0; k < places; ++k) {
    const double error = cylinder_drag(n, walls, 0.1 * k) / exact_drag - 1;
    e.rms += error * error / places;
    low = std::min(low, error);
    high = std::max(high, error);
  }
  return {std::sqrt(e.rms), high - low};
}

/// Root mean square errors on three lattices, of second order and below `bound` on the finest.
std::vector<test::Level> second_order_levels(const std::string& name, WallModel walls, double bound) {
  std::vector<test::Level> levels;
  for (const int n : {15, 30, 60}) levels.push_back({double(n), drag_errors(n, walls).rms});
  const auto orders =
      test::print_orders(("cylinder drag, " + name + " walls, rms error against the pitch").c_str(), levels);
  EXPECT_LT(levels.back().error, bound);
  for (const double order : orders) EXPECT_GT(order, 1.4);
  EXPECT_GT(0.5 * (orders[0] + orders[1]), 1.7);
  return levels;
}

TEST(CylinderArrayConvergence, InterpolatedWallsAreOfSecondOrderAndCentralLinearOnesBetter) {
  const auto interpolated = second_order_levels("interpolated", WallModel::interpolated, 3e-3),
             central = second_order_levels("central linear", WallModel::central_linear, 1.5e-3);
  for (std::size_t k = 0; k < central.size(); ++k)
    EXPECT_LT(central[k].error, 0.7 * interpolated[k].error) << central[k].size;
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

/// At fixed Lambda the steady Stokes flow between half-way or central linear walls does not depend on the
/// viscosity. Between interpolated walls it does.
TEST(CylinderArrayConvergence, DragDoesNotDependOnTheRelaxationTime) {
  const auto drag = [](WallModel walls, double tau) {
    FluidModel model;
    model.walls = walls;
    model.relaxation_time = tau;
    return test::measured_drag(test::cylinder_cell(20, 4.106), model, 1e-9);
  };
  const auto change = [&](WallModel walls, double tau) {
    return std::abs(drag(walls, tau) / drag(walls, 1.0) - 1);
  };
  for (const double tau : {0.7, 2.0}) {
    EXPECT_LT(change(WallModel::half_way, tau), 1e-7) << tau;
    EXPECT_LT(change(WallModel::central_linear, tau), 5e-6) << tau;
    EXPECT_GT(change(WallModel::interpolated, tau), 1e-3) << tau;
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
