/// A spherical capsule in shear at small deformation against theory, in radius / dx and in box / radius.
///
///   D = (5/8) eta gdot a (3/Gs + 1/Ks), Gs = 4 kS/k, Ks = Gs + 2 kalpha/3 (Barthes-Biesel, Diaz and Dhenin
///   2002, bending neglected), whatever the viscosity ratio.
///
/// The theory knows no walls and no lattice. Walls and periodic images add a term (a / box)^3, measured with
/// two boxes at the coarsest level and taken off at the others. The kernel gives the membrane a hydrodynamic
/// thickness of a part of dx, so that the rest falls between first and second order in dx / a: D is
/// extrapolated with 3/2.
#include <gtest/gtest.h>

#include "support/convergence.hpp"
#include "support/scene_run.hpp"

namespace dld {
namespace {

constexpr double box_over_radius = 8, wide_box_over_radius = 12;

/// D / theory - 1. radius in lattice spacings; k: Skalak denominator.
double deformation_error(int radius, double k, double viscosity_ratio, double box,
                         const std::string& kernel = "phi3") {
  Case c = test::case_of(R"({"scene": "shear", "fluid": {"lattice_spacing_um": 1},
      "cell": {"shape": "sphere", "local_area_modulus": 1, "global_area_modulus": 0, "bending_ratio": 1e-4},
      "coupling": {"kernel": "phi3", "regularisation": "none"}, "shear": {"duration": 2}})");
  c.coupling.kernel = kernel;
  c.cell.radius_um = radius;
  c.cell.mesh_frequency = radius;  // edge about 1 dx
  c.cell.viscosity_ratio = viscosity_ratio;
  c.cell.skalak_denominator = k;
  c.shear.capillary_number = 0.06 / k;      // the same Gs for every k
  c.shear.reynolds_number = 0.05 * radius;  // the same moduli in lattice units at every level; Stokes flow
  c.shear.box_um = box * radius;
  const test::SceneResult result = test::run_scene(c);
  EXPECT_EQ(result.status, Status::converged);
  return result.summary["deformation"].get<double>() / result.summary["deformation_theory"].get<double>() - 1;
}

/// Part of D / theory that the walls of the standard box add.
double confinement(double k, double viscosity_ratio) {
  const double narrow = deformation_error(4, k, viscosity_ratio, box_over_radius);
  const double wide = deformation_error(4, k, viscosity_ratio, wide_box_over_radius);
  const double ratio = box_over_radius / wide_box_over_radius;
  return (narrow - wide) / (1 - ratio * ratio * ratio);
}

class CapsuleInShear : public testing::TestWithParam<double> {};

TEST_P(CapsuleInShear, DeformationConvergesToTheory) {
  const double k = GetParam(), walls = confinement(k, 1);
  std::vector<test::Level> levels;
  for (const int radius : {4, 6, 8}) {
    levels.push_back({double(radius), deformation_error(radius, k, 1, box_over_radius) - walls});
  }
  std::printf("k = %g, walls add %.4f\n", k, walls);
  const auto orders = test::print_orders("D / theory - 1 against radius / dx", levels);
  const double growth = std::pow(levels[2].size / levels[1].size, 1.5);
  const double limit = (growth * levels[2].error - levels[1].error) / (growth - 1);
  std::printf("extrapolated %.4f\n", limit);
  EXPECT_GT(walls, 0.0);
  EXPECT_LT(walls, 0.03);
  for (const double order : orders) EXPECT_GT(order, 1.0);
  EXPECT_LT(std::abs(levels[2].error), 0.05);
  EXPECT_LT(std::abs(limit), 0.03);
}

TEST_P(CapsuleInShear, DeformationDoesNotDependOnTheViscosityRatio) {
  const double k = GetParam(), error = deformation_error(8, k, 5, box_over_radius) - confinement(k, 5);
  std::printf("k = %g, viscosity ratio 5: D / theory - 1 = %.4f\n", k, error);
  // The sharp inside/outside field adds an error of its own, of the order of a per cent.
  EXPECT_LT(std::abs(error), 0.04);
}

/// What phi4 takes from the velocity at the membrane is an error of first order; given back, the next order
/// shows. It has another sign and a larger factor: at a radius of 4 dx the correction does not pay yet.
TEST(CapsuleInShearCorrected, IsOfSecondOrder) {
  const double walls = confinement(12, 1);
  std::vector<test::Level> plain, corrected;
  for (const int radius : {4, 6, 8}) {
    plain.push_back({double(radius), deformation_error(radius, 12, 1, box_over_radius, "phi4") - walls});
    corrected.push_back(
        {double(radius), deformation_error(radius, 12, 1, box_over_radius, "phi4_corrected") - walls});
  }
  const auto plain_orders = test::print_orders("phi4: D / theory - 1 against radius / dx", plain);
  const auto orders = test::print_orders("phi4_corrected", corrected);
  for (const double order : plain_orders) EXPECT_LT(order, 1.7);
  for (const double order : orders) EXPECT_GT(order, 2.0);
  EXPECT_LT(std::abs(corrected.back().error), 0.055);
  EXPECT_LT(std::abs(corrected.back().error), std::abs(plain.back().error));
}

INSTANTIATE_TEST_SUITE_P(SkalakDenominator, CapsuleInShear, testing::Values(4.0, 12.0));

}  // namespace
}  // namespace dld
