/// A flat sheet with a tangential load t between two walls, against u = t / (eta / a + ratio eta / b), a and
/// b being its distances to them and ratio that of the viscosities below and above: what the kernel takes
/// from the kink of the velocity, and what is given back.
#include <gtest/gtest.h>

#include "coupling/immersed_boundary.hpp"
#include "support/convergence.hpp"
#include "support/fluid_box.hpp"

namespace dld {
namespace {

struct SheetErrors {
  double plain = 0, corrected = 0;  ///< relative errors of the sheet's velocity
  double across = 0;                ///< corrected velocity across the load over that along it
};

struct SheetScene {
  int height = 0;  ///< distance of the walls, lattice spacings
  double z = 0;    ///< of the sheet, from the middle, lattice spacings
  double magic = 3.0 / 16, ratio = 1;
};

/// share: what is given back, dx^2 F / eta.
SheetErrors sheet_errors(const SheetScene& scene, double share) {
  constexpr int width = 4, nodes = 2 * width;  // two nodes for a spacing
  const int height = scene.height;
  const test::BoxSize size{width, width, height, 0, 0, HeightBoundary::walls};
  FluidModel model;
  model.magic_parameter = scene.magic;
  Lattice<double> lattice(test::unit_cell(size), model);
  Eigen::MatrixX3d x(nodes * nodes, 3), f(nodes * nodes, 3), u(nodes * nodes, 3), load(nodes * nodes, 3);
  for (int i = 0; i < nodes; ++i) {
    for (int j = 0; j < nodes; ++j) x.row(i * nodes + j) << 0.5 * i, 0.5 * j, scene.z;
  }
  const double traction = 1e-4, eta = (model.relaxation_time - 0.5) / 3;
  test::set_relaxation_time_below(lattice, size, scene.z, 0.5 + 3 * scene.ratio * eta);
  f.rowwise() = Eigen::RowVector3d(0.25 * traction, 0, 0);
  ImmersedBoundary<double> boundary(lattice, Kernel::phi4, coupled_nodes(x, false));
  boundary.locate(x, std::vector<std::uint8_t>(static_cast<std::size_t>(x.rows()), 0));
  boundary.spread(f);
  const int steps = static_cast<int>(1.6 * height * height / eta);  // exp(-1.6 pi^2) of the start is left
  for (int k = 0; k < steps; ++k) lattice.step(boundary.active());
  boundary.interpolate(u);
  boundary.interpolate_force(load);
  const double above = 0.5 * height - scene.z, below = 0.5 * height + scene.z;
  const double exact = traction / (eta / above + scene.ratio * eta / below);
  const Eigen::MatrixX3d corrected = u + share / eta * load;
  EXPECT_LT((corrected.col(0).array() - corrected(0, 0)).abs().maxCoeff(), 1e-10 * exact);
  return {u(0, 0) / exact - 1, corrected(0, 0) / exact - 1,
          corrected.rightCols(2).cwiseAbs().maxCoeff() / exact};
}

class Sheet : public testing::TestWithParam<double> {};

TEST_P(Sheet, KernelAndLatticeTakeAFirstOrderShareThatIsGivenBack) {
  const double share = kernel_correction("phi4_corrected", 1, GetParam());
  for (const double place : {0.0, 0.23}) {
    std::vector<test::Level> plain, corrected;
    for (const int height : {8, 16, 32}) {
      const SheetErrors e = sheet_errors({height, place * height, GetParam()}, share);
      plain.push_back({double(height), e.plain});
      corrected.push_back({double(height), e.corrected});
      EXPECT_LT(e.across, 1e-12);
      EXPECT_LT(e.plain, 0.0);
      EXPECT_LT(std::abs(e.corrected), 0.04 * std::abs(e.plain));
    }
    const auto orders = test::print_orders("sheet, plain phi4 against H", plain);
    test::print_orders("sheet, corrected", corrected);
    for (const double order : orders) EXPECT_NEAR(order, 1.0, 0.1);
    EXPECT_LT(std::abs(corrected.back().error), 0.002);
  }
}

INSTANTIATE_TEST_SUITE_P(MagicParameter, Sheet, testing::Values(1.0 / 12, 3.0 / 16, 0.25));

/// Next to a wall with the thin fluid between, as a cell in contact: the gap is a fifth of the height.
class SheetWithJump : public testing::TestWithParam<double> {
 protected:
  /// Mean over places of the sheet between two lattice planes: where the jump stands is known to a spacing.
  static SheetErrors mean_errors(int height) {
    constexpr int places = 4;
    SheetErrors mean;
    for (int n = 0; n < places; ++n) {
      constexpr double magic = 3.0 / 16;
      const SheetErrors e = sheet_errors({height, 0.3 * height + (n + 0.5) / places - 0.5, magic, GetParam()},
                                         kernel_correction("phi4_corrected", GetParam(), magic));
      mean.plain += e.plain / places;
      mean.corrected += e.corrected / places;
      mean.across = std::max(mean.across, e.across);
    }
    return mean;
  }
};

TEST_P(SheetWithJump, TheMeanViscosityGivesBackMostOfTheError) {
  std::vector<test::Level> plain, corrected;
  for (const int height : {10, 20, 40}) {  // the kernel does not reach the wall
    const SheetErrors mean = mean_errors(height);
    plain.push_back({double(height), mean.plain});
    corrected.push_back({double(height), mean.corrected});
    EXPECT_LT(mean.across, 1e-12);
    EXPECT_LT(mean.plain, 0.0);
    EXPECT_LT(std::abs(mean.corrected), 0.6 * std::abs(mean.plain));
  }
  std::printf("viscosity ratio %g\n", GetParam());
  for (const double order : test::print_orders("sheet, plain", plain)) EXPECT_NEAR(order, 1.0, 0.3);
  test::print_orders("sheet, share of the mean viscosity given back", corrected);
}

INSTANTIATE_TEST_SUITE_P(ViscosityRatio, SheetWithJump, testing::Values(1.0, 2.0, 5.0, 10.0));

}  // namespace
}  // namespace dld
