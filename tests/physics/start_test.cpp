/// Where a passage begins, and that it only begins in a steady flow.
#include <gtest/gtest.h>

#include "support/scene_run.hpp"

namespace dld {
namespace {

/// Denser arrays than the paper's, with the paper's start 16 um before the pillar centres: on the line of the
/// row before, where the height of the separation streamline lies in a pillar.
TEST(PassageStart, TheSolverChoosesNoStartInAPillar) {
  for (const std::string geometry : {R"({"pitch_um": 16, "pillar_radius_um": 4, "row_shift_um": 1.6})",
                                     R"({"pitch_um": 20, "pillar_radius_um": 5, "row_shift_um": 4})"}) {
    const Case c = test::case_of(R"({"scene": "passage", "geometry": )" + geometry + R"(,
        "fluid": {"lattice_spacing_um": 0.8, "force_density": 5e-4}, "coupling": {"steps_per_update": 1},
        "cell": {"mesh_frequency": 5, "start": {"x_um": -16}},
        "stop": {"when": "rows", "max_rows": 1, "max_steps": 3000}, "output": {"flow_field": false}})");
    const test::SceneResult run = test::run_scene(c);
    EXPECT_NE(run.status, Status::diverged) << geometry;
    EXPECT_GT(run.summary["smallest_film_um"].get<double>(), 0.0) << geometry;
  }
}

TEST(PassageStart, NoCellIsPutIntoAFlowThatIsNotSteady) {
  const Case c = test::case_of(R"({"scene": "passage", "geometry": {"row_shift_um": 3.2},
      "fluid": {"lattice_spacing_um": 0.8, "force_density": 5e-4}, "cell": {"mesh_frequency": 5},
      "coupling": {"steps_per_update": 1}, "stop": {"max_steps": 400}, "output": {"flow_field": false}})");
  const test::SceneResult run = test::run_scene(c);
  EXPECT_EQ(run.status, Status::undecided);
  EXPECT_EQ(run.summary["steps"], 400);
  EXPECT_EQ(run.summary["membrane_updates"], 0);
  ASSERT_TRUE(run.summary.contains("reason"));
  EXPECT_NE(run.summary["reason"].get<std::string>().find("not steady"), std::string::npos);
}

}  // namespace
}  // namespace dld
