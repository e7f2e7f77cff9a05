/// The optical tweezer through the fluid against the energy minimum: at rest the fluid has no say.
#include <gtest/gtest.h>

#include "support/scene_run.hpp"

namespace dld {
namespace {

/// Extents by both methods within 1.5 %; the moduli are soft enough for the explicit coupling.
void compare(double lattice_spacing_um, int mesh_frequency) {
  Case c = test::case_of(R"({"scene": "stretching", "stretching": {"forces_pN": [20, 40, 80]},
      "cell": {"viscosity_ratio": 1, "local_area_modulus": 1,
               "global_area_modulus": 2, "volume_modulus": 10}})");
  c.fluid.lattice_spacing_um = lattice_spacing_um;
  c.cell.mesh_frequency = mesh_frequency;
  const test::SceneResult at_rest = test::run_scene(c);
  c.stretching.method = "coupled";
  const test::SceneResult coupled = test::run_scene(c);
  ASSERT_EQ(at_rest.status, Status::converged);
  ASSERT_EQ(coupled.status, Status::converged);
  std::printf("%8s %20s %20s\n", "F (pN)", "axial (um)", "transverse (um)");
  for (std::size_t k = 0; k < c.stretching.forces_pN.size(); ++k) {
    const auto both = [&](const char* name) {
      return std::pair{at_rest.summary[name][k].get<double>(), coupled.summary[name][k].get<double>()};
    };
    const auto [axial, axial_coupled] = both("axial_um");
    const auto [transverse, transverse_coupled] = both("transverse_um");
    std::printf("%8.0f %10.4f %9.4f %10.4f %9.4f\n", c.stretching.forces_pN[k], axial, axial_coupled,
                transverse, transverse_coupled);
    EXPECT_NEAR(axial_coupled / axial, 1, 0.015);
    EXPECT_NEAR(transverse_coupled / transverse, 1, 0.015);
    EXPECT_GT(axial, 10.0);
  }
}

TEST(CoupledStretching, AgreesWithTheEnergyMinimumOnACoarseLattice) {
  compare(0.78, 5);
}

TEST(CoupledStretching, SlowAgreesWithTheEnergyMinimumAtTheWorkingResolution) {
  compare(0.4, 10);
}

TEST(CoupledStretching, ARunThatFliesApartIsLabelled) {
  const test::SceneResult result = test::run_scene(
      test::case_of(R"({"scene": "stretching", "stretching": {"method": "coupled", "forces_pN": [20000]}})"));
  EXPECT_EQ(result.status, Status::diverged);
  EXPECT_EQ(result.summary["failing_quantity"], "speed of the membrane");
  EXPECT_GE(result.summary["failing_value"].get<double>(), 1.0);
}

}  // namespace
}  // namespace dld
