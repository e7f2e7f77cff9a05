/// The estimate of the device's friction against the flow of the solver.
#include "geometry/friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "parameters/flow_estimate.hpp"
#include "parameters/limits.hpp"
#include "parameters/units.hpp"
#include "support/scene_run.hpp"

namespace dld {
namespace {

constexpr double pitch = 32;

ArrayGeometry array(double radius, double depth, double row_shift) {
  const auto distance = [=](double x, double y) {
    double nearest = pitch;
    for (int n = -1; n <= 1; ++n) {
      for (int m = -2; m <= 2; ++m) {
        nearest = std::min(nearest, std::hypot(x - n * pitch, y - n * row_shift - m * pitch) - radius);
      }
    }
    return nearest;
  };
  return {pitch, pitch, row_shift, depth, pitch - 2 * radius, distance};
}

/// Mean velocity of the solver, free lateral flow, d = 6.4 um unless said: u nu / f in um^2, measured once
/// with dx = 0.8 um (0.4 where the gap is narrow and the device shallow), tau 1, to 1e-6 per 100 steps.
struct Flow {
  double radius, depth, row_shift, mobility, lateral_ratio, largest_over_mean;
};

double mobility(double u, double dx) {
  return u / 6 / 1e-5 * dx * dx;
}

const std::vector<Flow> flows = {
    {5.6, 4.8, 6.4, mobility(1.478960e-4, 0.8), 0.00212, 2.24},
    {10, 4.8, 6.4, mobility(1.095700e-4, 0.8), 0.01761, 3.19},
    {14, 4.8, 6.4, mobility(1.969073e-4, 0.4), 0.09367, 6.36},
    {15, 4.8, 6.4, mobility(7.768929e-5, 0.4), 0.14451, 9.05},
    {5.6, 12.8, 6.4, mobility(7.988408e-4, 0.8), 0.00706, 2.53},
    {10, 12.8, 6.4, mobility(4.568315e-4, 0.8), 0.04073, 3.66},
    {15, 12.8, 6.4, mobility(1.066706e-4, 0.4), 0.17542, 7.97},
    {8, 24, 6.4, mobility(1.207742e-3, 0.8), 0.03560, 3.08},
    {12, 24, 6.4, mobility(1.586598e-3, 0.4), 0.10428, 4.11},
    {15, 24, 6.4, mobility(1.145528e-4, 0.4), 0.18144, 7.59},
    {5.6, 48, 6.4, mobility(2.942607e-3, 0.8), 0.02701, 2.52},
    {10, 48, 6.4, mobility(1.000578e-3, 0.8), 0.07890, 3.21},
    {12, 48, 6.4, mobility(4.749627e-4, 0.8), 0.11563, 3.68},
};

TEST(Friction, IsThatOfTheSolversFlow) {
  for (const Flow& flow : flows) {
    const Mobility m = estimate_mobility(array(flow.radius, flow.depth, flow.row_shift));
    std::printf("R %4.1f um, H %4.1f um: mobility %6.3f um^2, over the solver's %.3f; u_y/u_x %.4f (%.4f)\n",
                flow.radius, flow.depth, m.xx, m.xx / flow.mobility, m.lateral_ratio(), flow.lateral_ratio);
    EXPECT_NEAR(m.xx / flow.mobility, 1, friction_uncertainty) << flow.radius << " " << flow.depth;
    EXPECT_NEAR(m.lateral_ratio() / flow.lateral_ratio, 1, 0.09) << flow.radius << " " << flow.depth;
    EXPECT_NEAR(m.largest / m.xx / flow.largest_over_mean, 1, 0.06) << flow.radius << " " << flow.depth;
  }
}

TEST(Friction, OfThinPillarsIsThatOfTheSlit) {
  const Mobility m = estimate_mobility(array(0.05, 4.8, 0));
  EXPECT_NEAR(m.xx / slit_mobility(4.8).xx, 1, 0.02);
}

// Onsager: the force along one axis drives across what the other drives along.
TEST(Friction, MobilityIsSymmetric) {
  for (const double shift : {0.0, 3.2, 9.6}) {
    const Mobility m = estimate_mobility(array(12, 24, shift));
    EXPECT_NEAR(m.xy, m.yx, 0.01 * m.xx);
    EXPECT_LE(m.blocked(), m.xx * (1 + 1e-9));
  }
  const Mobility even = estimate_mobility(array(12, 24, 0));
  EXPECT_NEAR(even.yy, even.xx, 1e-6 * even.xx);
}

TEST(Friction, ADeepNarrowDeviceIsNotRefused) {
  const Case c = test::case_of(R"({"scene": "streamlines", "fluid": {"lattice_spacing_um": 0.2},
      "geometry": {"pitch_um": 8, "pillar_radius_um": 3.2, "epsilon": 0.1, "depth_um": 10}})");
  EXPECT_FALSE(expected_to_diverge(stability_margins(c)));
  EXPECT_NEAR(estimate_flow(c).largest_speed, 0.0477, 0.1 * 0.0477);  // that of its run
}

// The paper's device keeps the bits of its flow: its control goes by the friction of the slit, as ever.
TEST(Friction, TheControlOfTheShallowDeviceIsThatOfTheSlit) {
  const Case c;
  ASSERT_TRUE(is_shallow(c));
  const LatticeParameters l = to_lattice(c);
  EXPECT_EQ(lateral_friction(c), 1.5 * 12.0 * l.viscosity / (l.depth * l.depth));
}

Case deep(const char* lateral_flow) {
  Case c = test::case_of(R"({"scene": "streamlines", "geometry": {"row_shift_um": 3.2, "depth_um": 36.8},
      "fluid": {"lattice_spacing_um": 0.8, "relaxation_time": 1, "force_density": 1e-5},
      "stop": {"steady_tolerance": 1e-5, "max_steps": 6000}, "output": {"flow_field": false}})");
  c.fluid.lateral_flow = lateral_flow;
  return c;
}

TEST(Friction, BlockedFlowSettlesInADeepArraySlow) {
  const auto blocked = test::run_scene(deep("blocked"));
  EXPECT_EQ(blocked.status, Status::converged);
  EXPECT_LT(blocked.summary["steps"].get<long>(), 6000);
  EXPECT_FALSE(blocked.summary.contains("lateral_share_of_epsilon"));

  // The free one drifts along with the rows, which is said before the run and after it.
  const Case c = deep("free");
  const auto margins = stability_margins(c);
  const auto said = std::ranges::find(margins, "lateral flow, share of epsilon", &Margin::name);
  ASSERT_NE(said, margins.end());
  EXPECT_FALSE(said->ok);
  const auto free = test::run_scene(c);
  const double share = free.summary["lateral_share_of_epsilon"];
  EXPECT_NEAR(said->value, share, 0.1 * share);
  const double ratio =
      free.summary["separation_um"].get<double>() / blocked.summary["separation_um"].get<double>();
  EXPECT_NEAR(free.summary["separation_over_blocked"].get<double>(), ratio, 0.05);
}

}  // namespace
}  // namespace dld
