/// A nearly rigid sphere in the array: it bumps when it is larger than the critical diameter 2 s of the
/// streamlines, and zigzags when it is smaller.
#include <gtest/gtest.h>

#include "support/scene_run.hpp"

namespace dld {
namespace {

constexpr double row_shift_um = 3.2;
constexpr double tolerance_um = 0.4;  ///< of the diameter

double critical_diameter_um() {
  Case c = test::case_of(R"({"scene": "streamlines"})");
  c.geometry.row_shift_um = row_shift_um;
  return 2 * test::run_scene(c).summary["separation_um"].get<double>();
}

test::SceneResult sphere(double radius_um) {
  Case c = test::case_of(R"({"scene": "passage", "output": {"flow_field": false},
      "cell": {"shape": "sphere", "radius_um": 1.7, "mesh_frequency": 5,
                "capillary_number": 0.05, "viscosity_ratio": 1}})");
  // The film between sphere and pillar is a part of dx: refine it away.
  c.fluid.lattice_spacing_um = 4.0 / 15;
  c.fluid.force_density = 1.5e-4;
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
