/// Flow through the row-shifted array of the device at half resolution: separation distances in Stokes flow.
#include <gtest/gtest.h>

#include "measure/streamlines.hpp"
#include "scene/steady_flow.hpp"
#include "support/fluid_box.hpp"

namespace dld {
namespace {

struct Separations {
  double downstream = 0, upstream = 0;  ///< s at the lower and at the upper pillar, lattice units
  double mean_velocity = 0, lateral_velocity = 0;
};

/// Unit cell of 32 x 32 x 4.8 um at dx = 0.8 um, d = 4 um.
Separations separations(double origin_x, double origin_y, EquilibriumModel equilibrium, double force) {
  const test::BoxSize size{40, 40, 3, 12.5, 5, HeightBoundary::mirror_and_wall};
  FluidModel model;
  model.equilibrium = equilibrium;
  Lattice<double> lattice(test::unit_cell(size, origin_x, origin_y), model);
  lattice.set_uniform_force(force, 0, 0);
  const auto mean = test::steady_mean_velocity(lattice, 1e-11);
  const auto array = test::pillar_array(size);
  const PlaneField field =
      mid_plane(lattice, [&](double x, double y) { return array->signed_distance(x, y); });
  const PlaneFlow flow = field.flow({0, size.radius, size.ny - size.radius});
  return {separation_downstream(flow).seed_distance, separation_upstream(flow).seed_distance, mean[0],
          mean[1]};
}

TEST(ArrayFlow, BothSeparatricesHaveTheSameDistanceInStokesFlow) {
  const Separations s = separations(-20, -20, EquilibriumModel::stokes, 1e-6);
  std::printf("s %.6f lu, s_upper %.6f lu, difference %.2e, u_y/u_x %.5f\n", s.downstream, s.upstream,
              s.downstream - s.upstream, s.lateral_velocity / s.mean_velocity);
  EXPECT_NEAR(s.downstream, s.upstream, 1e-4);
  EXPECT_GT(s.downstream, 1.0);
  // A force along x alone drives a flow across, of the order of one per cent.
  EXPECT_GT(std::abs(s.lateral_velocity / s.mean_velocity), 1e-3);
  EXPECT_LT(std::abs(s.lateral_velocity / s.mean_velocity), 0.05);
}

TEST(ArrayFlow, OriginOfTheUnitCellDoesNotMatter) {
  const Separations s = separations(-20, -20, EquilibriumModel::stokes, 1e-6);
  for (const auto& [x, y] : {std::pair{-3, -39}, {0, -7}}) {
    const Separations moved = separations(x, y, EquilibriumModel::stokes, 1e-6);
    EXPECT_NEAR(moved.downstream, s.downstream, 1e-5);
    EXPECT_NEAR(moved.mean_velocity / s.mean_velocity, 1, 1e-9);
  }
}

TEST(ArrayFlow, InertiaTellsTheSeparatricesApart) {
  const Separations s = separations(-20, -20, EquilibriumModel::full, 2e-3);
  std::printf("with inertia: s %.6f lu, s_upper %.6f lu\n", s.downstream, s.upstream);
  EXPECT_GT(std::abs(s.downstream - s.upstream), 1e-3);
}

}  // namespace
}  // namespace dld
