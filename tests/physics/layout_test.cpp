/// The two layouts of an array: rows shifted against each other, and a square array driven at an angle.
#include <gtest/gtest.h>

#include "support/scene_run.hpp"

namespace dld {
namespace {

nlohmann::ordered_json flow(const std::string& geometry, const std::string& lateral_flow = "free") {
  const Case c = test::case_of(R"({"scene": "streamlines", "geometry": {)" + geometry +
                               R"(, "pillar": {"shape": "circle", "radius_um": 10}},
      "fluid": {"lattice_spacing_um": 0.8, "force_density": 1e-5, "precision": "double", "lateral_flow": ")" +
                               lateral_flow + R"("}, "stop": {"steady_tolerance": 1e-9},
      "output": {"flow_field": false}})");
  const test::SceneResult run = test::run_scene(c);
  EXPECT_EQ(run.status, Status::converged);
  return run.summary;
}

double number(const nlohmann::ordered_json& summary, const char* name) {
  return summary[name].get<double>();
}

/// Stokes flow is linear, and a square array of circles looks the same after a quarter turn: the flow follows
/// the force whatever its direction, and the resistance is that of the array along its rows.
TEST(RotatedSquare, IsIsotropic) {
  const auto straight = flow(R"("row_shift_um": 0)");
  const auto turned = flow(R"("layout": "rotated_square", "epsilon": 0.1)");
  EXPECT_NEAR(number(turned, "lateral_velocity_ratio"), 0, 1e-6);
  EXPECT_NEAR(number(turned, "resistance_Pa_s_per_m2") / number(straight, "resistance_Pa_s_per_m2"), 1, 1e-6);
  EXPECT_NEAR(turned["device"]["tilt_deg"].get<double>(), 5.7106, 1e-4);
}

TEST(RotatedSquare, SeparationGrowsWithTheAngleAndIsTheSameOnBothSides) {
  double previous = 0;
  for (const char* epsilon : {"0.05", "0.1", "0.2"}) {
    const auto turned = flow(R"("layout": "rotated_square", "epsilon": )" + std::string(epsilon));
    const double s = number(turned, "separation_um");
    std::printf("rotated square, epsilon %s: s %.4f um\n", epsilon, s);
    EXPECT_NEAR(s, number(turned, "separation_upper_um"), 1e-4);
    EXPECT_GT(s, previous + 0.2);
    previous = s;
  }
}

TEST(RotatedSquare, BlockedLateralFlowNeedsNoForce) {
  const auto turned = flow(R"("layout": "rotated_square", "epsilon": 0.1)", "blocked");
  EXPECT_NEAR(number(turned, "lateral_velocity_ratio"), 0, 1e-6);
  EXPECT_NEAR(number(turned, "lateral_force_ratio"), 0, 1e-5);
}

/// The rows of a shifted array are no mirror lines: a force along x drives a flow across, which side walls
/// stop.
TEST(RowShifted, BlockedLateralFlowNeedsAForceAcross) {
  for (const std::string pitches : {R"("pitch_um": 32)", R"("pitch_um": 32, "pitch_y_um": 28)"}) {
    const auto free = flow(pitches + R"(, "row_shift_um": 4)");
    const auto blocked = flow(pitches + R"(, "row_shift_um": 4)", "blocked");
    EXPECT_GT(std::abs(number(free, "lateral_velocity_ratio")), 1e-3);
    EXPECT_NEAR(number(blocked, "lateral_velocity_ratio"), 0, 1e-6);
    EXPECT_GT(std::abs(number(blocked, "lateral_force_ratio")), 1e-3);
  }
}

}  // namespace
}  // namespace dld
