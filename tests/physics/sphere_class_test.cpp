/// A nearly rigid sphere in the array: it bumps when it is larger than the critical diameter 2 s of the
/// streamlines, and zigzags when it is smaller. With the corrected kernel and its walls, because the plain
/// kernel keeps a sphere off the pillar by a part of a lattice spacing, which is that much in its diameter.
#include <gtest/gtest.h>

#include "support/scene_run.hpp"

namespace dld {
namespace {

constexpr double row_shift_um = 3.2;
constexpr double lattice_spacing_um = 4.0 / 15;
constexpr double tolerance_um = 0.4;  ///< of the diameter

double critical_diameter_um() {
  Case c = test::case_of(R"({"scene": "streamlines", "accuracy": "corrected"})");
  c.fluid.lattice_spacing_um = lattice_spacing_um;
  c.geometry.row_shift_um = row_shift_um;
  return 2 * test::run_scene(c).summary["separation_um"].get<double>();
}

test::SceneResult sphere(double radius_um) {
  // The contact stays at 0.1 um (Presets.HoldTheContactOfTheCorrectedKernelAtATenthOfAMicrometre).
  Case c = test::case_of(R"({"scene": "passage", "accuracy": "corrected", "output": {"flow_field": false},
      "cell": {"shape": "sphere", "radius_um": 1.7, "mesh_frequency": 5,
                "capillary_number": 0.05, "viscosity_ratio": 1},
      "fluid": {"relaxation_time": 1.45, "force_density": 1.4976e-4},
      "coupling": {"pillar_repulsion": 0.396, "wall_repulsion": 0.396, "repulsion_range": 0.375}})");
  c.fluid.lattice_spacing_um = lattice_spacing_um;
  c.geometry.row_shift_um = row_shift_um;
  c.cell.radius_um = radius_um;
  const test::SceneResult result = test::run_scene(c);
  std::printf("diameter %.2f um: %s, smallest film %.3f um\n", 2 * radius_um,
              to_string(result.status).c_str(), result.summary["smallest_film_um"].get<double>());
  return result;
}

TEST(SphereInTheArray, SlowSwitchesItsClassAtTheCriticalDiameter) {
  const double critical = critical_diameter_um();
  std::printf("critical diameter 2 s = %.3f um\n", critical);
  EXPECT_EQ(sphere(0.5 * (critical - tolerance_um)).status, Status::zigzag);
  EXPECT_EQ(sphere(0.5 * (critical + tolerance_um)).status, Status::displaced);
}

}  // namespace
}  // namespace dld
