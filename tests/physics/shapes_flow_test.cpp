/// Cell-free flow past pillars that are no circles: mass, the symmetry that the shape implies, and the order
/// in which separation and resistance converge over three lattices. Stokes flow, trt, interpolated walls.
#include <gtest/gtest.h>

#include <map>

#include "measure/streamlines.hpp"
#include "scene/setup.hpp"
#include "scene/steady_flow.hpp"
#include "support/scene_run.hpp"

namespace dld {
namespace {

const std::string triangle =
    R"({"shape": "polygon", "sides": 3, "circumradius_um": 10, "corner_radius_um": 1)";
const std::string upwards = triangle + "}", downwards = triangle + R"(, "rotation_deg": 180})";
const std::string ellipse = R"({"shape": "ellipse", "semi_axes_um": [11, 7], "rotation_deg": 30})";

struct Flow {
  double s = 0, s_upper = 0;  ///< um
  double resistance = 0;      ///< force density over the mean velocity, in units of eta / um^2
  double lateral = 0;         ///< mean u_y / u_x
  double flux_variation = 0;  ///< largest relative difference between the fluxes through two cross-sections
};

/// An array of pitches 32 x 28.8 um, depth 9.6 um, shift 4.8 um: on the lattices of 1.6, 0.8 and 0.4 um.
Case case_with(const std::string& pillar, double dx_um, double shift_um) {
  Case c = test::case_of(R"({"scene": "streamlines", "geometry": {"pitch_y_um": 28.8, "depth_um": 9.6,
      "row_shift_um": )" +
                         std::to_string(shift_um) + R"(, "pillar": )" + pillar + R"(},
      "fluid": {"precision": "double", "force_density": 1e-5, "lattice_spacing_um": )" +
                         std::to_string(dx_um) + "}}");
  return c;
}

Flow flow_past(const std::string& pillar, double dx_um, double shift_um = 4.8) {
  const Case c = case_with(pillar, dx_um, shift_um);
  const LatticeParameters l = to_lattice(c);
  const Device device = device_lu(c);
  const UnitCell cell = make_unit_cell(c, device);
  Lattice<double> lattice(cell, make_fluid_model(c));
  lattice.set_uniform_force(l.force_density, 0.0, 0.0);
  std::FILE* nowhere = std::fopen("/dev/null", "w");
  Progress progress(nowhere, false);
  const SteadyState steady = run_to_steady_state(lattice, LateralFlow(false, l, 0.0), 1e-9, 100000, progress);
  std::fclose(nowhere);
  EXPECT_EQ(steady.status, Status::converged);
  Flow result;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int x = 0; x < cell.nx; ++x) {
    double flux = 0;
    for (int y = 0; y < cell.ny; ++y) {
      for (int z = 0; z < cell.nz; ++z)
        if (!cell.is_solid(x, y, z)) flux += lattice.moments(x, y, z)[1];
    }
    least = std::min(least, flux), most = std::max(most, flux);
  }
  result.flux_variation = (most - least) / most;
  const PlaneField field =
      mid_plane(lattice, [&](double x, double y) { return device.pillars().signed_distance(x, y); });
  const PlaneFlow flow = field.flow(device.gap_line());
  result.s = separation_downstream(flow).seed_distance * dx_um;
  result.s_upper = separation_upstream(flow).seed_distance * dx_um;
  // The mean over the whole cell: the share of fluid nodes depends on the lattice.
  const double open = static_cast<double>(cell.fluid_nodes()) / static_cast<double>(cell.solid.size());
  result.resistance = l.force_density / (steady.flow.velocity[0] * open * l.viscosity * dx_um * dx_um);
  result.lateral = steady.flow.velocity[1] / steady.flow.velocity[0];
  std::printf("%s dx %.1f: s %.5f, %.5f um, resistance %.6f, u_y/u_x %.5f, flux %.1e\n", pillar.c_str(),
              dx_um, result.s, result.s_upper, result.resistance, result.lateral, result.flux_variation);
  return result;
}

/// Stokes flow is the same backwards. Turned by half a turn and backwards, an array of triangles pointing up
/// is one of triangles pointing down: below the one is above the other.
TEST(FlowPastShapes, TriangleUpsideDownExchangesTheTwoSides) {
  const Flow up = flow_past(upwards, 0.8), down = flow_past(downwards, 0.8);
  EXPECT_NEAR(up.s, down.s_upper, 1e-4);
  EXPECT_NEAR(up.s_upper, down.s, 1e-4);
  EXPECT_NEAR(up.resistance / down.resistance, 1, 1e-6);
  EXPECT_GT(std::abs(up.s - up.s_upper), 0.1);
}

/// Mirrored about its axis and backwards, the triangle stays and the shift changes sign (28.8 - 4.8 um is
/// -4.8).
TEST(FlowPastShapes, TriangleIsTheSameForAShiftToTheOtherSide) {
  const Flow right = flow_past(upwards, 0.8), left = flow_past(upwards, 0.8, 24);
  EXPECT_NEAR(right.resistance / left.resistance, 1, 1e-6);
  EXPECT_NEAR(right.lateral, -left.lateral, 1e-6);
  const double gap = device_um(case_with(upwards, 0.8, 4.8)).gap();
  EXPECT_NEAR(right.s + left.s_upper, gap, 1e-3);
  EXPECT_NEAR(right.s_upper + left.s, gap, 1e-3);
}

TEST(FlowPastShapes, PointSymmetricEllipseHasTheSameSeparationOnBothSides) {
  const Flow flow = flow_past(ellipse, 0.8);
  EXPECT_NEAR(flow.s, flow.s_upper, 1e-4);
  EXPECT_GT(flow.s, 0.5);
}

double order(double coarse, double middle, double fine) {
  return std::log2(std::abs((coarse - middle) / (middle - fine)));
}

TEST(FlowPastShapes, ConvergeOverThreeLattices) {
  for (const auto& pillar : {upwards, ellipse}) {
    const Flow a = flow_past(pillar, 1.6), b = flow_past(pillar, 0.8), c = flow_past(pillar, 0.4);
    std::printf("orders: s %.2f, s_upper %.2f, resistance %.2f\n", order(a.s, b.s, c.s),
                order(a.s_upper, b.s_upper, c.s_upper), order(a.resistance, b.resistance, c.resistance));
    EXPECT_LT(c.flux_variation, 3e-3);
    EXPECT_LT(c.flux_variation, 0.2 * a.flux_variation);
    EXPECT_GT(order(a.resistance, b.resistance, c.resistance), 1.7);
    EXPECT_GT(order(a.s, b.s, c.s), 1.7);
    EXPECT_GT(order(a.s_upper, b.s_upper, c.s_upper), 1.7);
    // What is left on the finest lattice, at second order.
    EXPECT_LT(std::abs(c.s - b.s) / 3, 0.03);
    EXPECT_LT(std::abs(c.s_upper - b.s_upper) / 3, 0.03);
    EXPECT_LT(std::abs(c.resistance / b.resistance - 1) / 3, 2e-3);
  }
}

}  // namespace
}  // namespace dld
