/// A drive in SI units against the flow of its run.
#include <gtest/gtest.h>

#include "geometry/friction.hpp"
#include "support/scene_run.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;

// The speed that was asked for, the speed that the flow has, and the Ca that would have met it.
TEST(Operating, ARunSaysBothNumbers) {
  const Case c = test::case_of(
      R"({"scene": "streamlines", "geometry": {"row_shift_um": 3.2},
          "fluid": {"lattice_spacing_um": 0.8, "relaxation_time": 1, "force_density": 1e-4},
          "stop": {"steady_tolerance": 1e-6}, "operating": {"mean_speed_um_per_s": 500}})");
  const Json summary = test::run_scene(c).summary["operating"];
  EXPECT_NEAR(summary["mean_speed_um_per_s"].get<double>(), 500, 1e-9);
  const double measured = summary["measured"]["mean_speed_um_per_s"];
  EXPECT_NEAR(measured / 500, 1, friction_uncertainty);
  EXPECT_NE(measured, 500);
  EXPECT_NEAR(summary["capillary_number_that_meets_the_drive"].get<double>() * measured / 500,
              c.cell.capillary_number, 1e-12);
}

}  // namespace
}  // namespace dld
