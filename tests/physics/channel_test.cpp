/// Plane Poiseuille and Couette flow: exact for TRT with Lambda = 3/16, the known slip for every other
/// Lambda.
#include <gtest/gtest.h>

#include "support/duct.hpp"

namespace dld {
namespace {

using test::duct_cell;
using test::plane_velocity;
using test::steady_duct;
using test::viscosity;

constexpr int height = 12;
constexpr double force = 1e-6;

/// Errors of the profile, relative to the exact centre velocity.
struct ProfileError {
  double largest = 0, mean = 0;
};

ProfileError profile_error(const FluidModel& model, bool mirror = false) {
  const UnitCell cell = duct_cell(0, height, mirror);
  const Lattice<double> lattice = steady_duct(cell, model, force, 1e-14);
  const double f_over_nu = force / viscosity(model), centre = plane_velocity(0, height, f_over_nu);
  ProfileError e;
  for (int z = 0; z < cell.nz; ++z) {
    const double error =
        (lattice.moments(1, 1, z)[1] - plane_velocity(z + cell.origin_z, height, f_over_nu)) / centre;
    e.largest = std::max(e.largest, std::abs(error));
    e.mean += error / cell.nz;
  }
  return e;
}

TEST(PlaneChannel, TrtWithThreeSixteenthsIsExact) {
  for (const double tau : {0.6, 1.0, 3.0}) {
    for (const bool mirror : {false, true}) {
      FluidModel model;
      model.relaxation_time = tau;
      EXPECT_LT(profile_error(model, mirror).largest, 1e-10) << "tau " << tau;
    }
  }
}

/// u_slip / u_centre = (16 Lambda / 3 - 1) / H^2 (Ginzburg and d'Humieres 2003), Lambda = (tau - 1/2)^2 for
/// BGK.
TEST(PlaneChannel, SlipFollowsTheMagicParameter) {
  std::printf("%10s %8s %8s %14s %14s\n", "collision", "tau", "Lambda", "slip", "theory");
  const auto check = [](const char* name, const FluidModel& model, double lambda) {
    const double theory = (16 * lambda / 3 - 1) / (height * height), slip = profile_error(model).mean;
    std::printf("%10s %8.2f %8.4f %14.6e %14.6e\n", name, model.relaxation_time, lambda, slip, theory);
    EXPECT_NEAR(slip, theory, 0.01 * std::abs(theory));
  };
  for (const double tau : {0.6, 1.0, 3.0}) {
    for (const double lambda : {1.0 / 12, 1.0 / 4, 2.0}) {
      FluidModel model;
      model.relaxation_time = tau;
      model.magic_parameter = lambda;
      check("TRT", model, lambda);
    }
    FluidModel bgk;
    bgk.collision = CollisionModel::bgk;
    bgk.relaxation_time = tau;
    check("BGK", bgk, (tau - 0.5) * (tau - 0.5));
  }
}

/// Full equilibrium: the profile is the same, inertia vanishes in a plane channel.
TEST(PlaneChannel, InertiaChangesNothing) {
  FluidModel model;
  model.equilibrium = EquilibriumModel::full;
  EXPECT_LT(profile_error(model).largest, 1e-10);
}

TEST(PlaneChannel, CouetteFlowIsLinear) {
  FluidModel model;
  model.wall_motion = {-0.01, 0.02};
  const UnitCell cell = duct_cell(0, height);
  Lattice<double> lattice(cell, model);
  test::steady_mean_velocity(lattice, 1e-14);
  for (int z = 0; z < height; ++z) {
    EXPECT_NEAR(lattice.moments(0, 1, z)[1], -0.01 + 0.03 * (z + 0.5) / height, 1e-12);
  }
}

/// Stokes equilibrium: the flow is exactly proportional to the force.
TEST(StokesFlow, VelocityIsProportionalToTheForce) {
  const test::BoxSize size{20, 20, 4, 6.3, 5, HeightBoundary::mirror_and_wall};
  const auto velocity_over_force = [&](double f) {
    Lattice<double> lattice(test::unit_cell(size), FluidModel{});
    lattice.set_uniform_force(f, 0, 0);
    for (int k = 0; k < 500; ++k) lattice.step();
    return lattice.statistics().velocity[0] / f;
  };
  const double reference = velocity_over_force(1e-6);
  for (const double f : {1e-9, 1e-4, 1e-2}) EXPECT_NEAR(velocity_over_force(f) / reference, 1, 1e-10);
}

/// A force on the middle plane of a channel shears the fluid on both sides of it: u = F / (2 nu) (W/2 - |y|).
/// Largest error beside the loaded plane, relative to the velocity in the middle. nz = 1: periodic in z.
double linear_flow_error(double width, const FluidModel& model) {
  UnitCell cell;
  cell.nx = 2, cell.ny = 15, cell.nz = 1;
  cell.height = HeightBoundary::periodic;
  cell.origin_y = -7;
  cell.distance = [width](double, double y, double) { return 0.5 * width - std::abs(y); };
  mark_solid(cell, true);
  Lattice<double> lattice(cell, model);
  for (int x = 0; x < cell.nx; ++x) lattice.force[0][lattice.layout().node(x, 7, 0)] = force;
  const std::vector<ActiveRange> middle(2, ActiveRange{7, 1});
  std::fill(lattice.relaxation_time.begin(), lattice.relaxation_time.end(), model.relaxation_time);
  for (int k = 0; k < 20000; ++k) lattice.step(middle);
  const double slope = force / (2 * viscosity(model));
  double largest = 0;
  for (int j = 0; j < cell.ny; ++j) {
    const double y = cell.origin_y + j;
    if (cell.is_solid(0, j, 0) || y == 0) continue;
    const double error = lattice.moments(0, j, 0)[1] / slope - (0.5 * width - std::abs(y));
    largest = std::max(largest, std::abs(error) / (0.5 * width));
  }
  return largest;
}

TEST(PlaneChannel, LinearFlowIsExactWhereverAnInterpolatedWallCutsTheLinks) {
  for (const auto walls : {WallModel::interpolated, WallModel::central_linear}) {
    for (const double width : {10.3, 10.9, 11.4, 11.9}) {
      for (const double tau : {0.8, 1.5}) {
        FluidModel model;
        model.walls = walls;
        model.relaxation_time = tau;
        EXPECT_LT(linear_flow_error(width, model), 1e-10) << width << ", tau " << tau;
      }
    }
  }
  FluidModel half_way;
  half_way.walls = WallModel::half_way;
  EXPECT_GT(linear_flow_error(10.3, half_way), 1e-2);
}

}  // namespace
}  // namespace dld
