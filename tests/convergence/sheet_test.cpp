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

/// `height`: distance of the walls in lattice spacings; `place` of the sheet in units of it, from the middle.
SheetErrors sheet_errors(int height, double place, double magic, double ratio = 1) {
  constexpr int width = 6, nodes = 2 * width;  // two nodes for a spacing
  const test::BoxSize size{width, width, height, 0, 0, HeightBoundary::walls};
  FluidModel model;
  model.magic_parameter = magic;
  Lattice<double> lattice(test::unit_cell(size), model);
  Eigen::MatrixX3d x(nodes * nodes, 3), f(nodes * nodes, 3), u(nodes * nodes, 3), load(nodes * nodes, 3);
  for (int i = 0; i < nodes; ++i) {
    for (int j = 0; j < nodes; ++j) x.row(i * nodes + j) << 0.5 * i, 0.5 * j, place * height;
  }
  const double traction = 1e-4, eta = (model.relaxation_time - 0.5) / 3;
  for (int z = 0; z < height && test::first_layer(size) + z < place * height; ++z) {
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < width; ++j)
        lattice.relaxation_time[lattice.layout().node(i, j, z)] = 0.5 + 3 * ratio * eta;
    }
  }
  f.rowwise() = Eigen::RowVector3d(0.25 * traction, 0, 0);
  ImmersedBoundary<double> boundary(lattice, Kernel::phi4, coupled_nodes(x, false));
  boundary.locate(x, std::vector<std::uint8_t>(static_cast<std::size_t>(x.rows()), 0));
  boundary.spread(f);
  const int steps = static_cast<int>(3 * height * height / eta);  // exp(-pi^2 3): the start is forgotten
  for (int k = 0; k < steps; ++k) lattice.step(boundary.active());
  boundary.interpolate(u);
  boundary.interpolate_force(load);
  const double above = (0.5 - place) * height, below = (0.5 + place) * height;
  const double exact = traction / (eta / above + ratio * eta / below), mean_eta = 0.5 * (1 + ratio) * eta;
  const Eigen::MatrixX3d corrected = u + (kink_share<Phi4>() + lattice_kink_share(magic)) / mean_eta * load;
  EXPECT_LT((corrected.col(0).array() - corrected(0, 0)).abs().maxCoeff(), 1e-10 * exact);
  return {u(0, 0) / exact - 1, corrected(0, 0) / exact - 1,
          corrected.rightCols(2).cwiseAbs().maxCoeff() / exact};
}

class Sheet : public testing::TestWithParam<double> {};

TEST_P(Sheet, KernelAndLatticeTakeAFirstOrderShareThatIsGivenBack) {
  for (const double place : {0.0, 0.23}) {
    std::vector<test::Level> plain, corrected;
    for (const int height : {8, 16, 32}) {
      const SheetErrors e = sheet_errors(height, place, GetParam());
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

// The load pushes the thinner fluid more, and the share given back is that of the mean viscosity: next to a
// wall with the thin fluid between (a cell in contact) the error of first order becomes smaller and stays.
TEST(SheetWithJump, AJumpOfTheViscosityIsGivenBackInPart) {
  std::vector<test::Level> plain, corrected;
  for (const int height : {10, 20, 40}) {
    const SheetErrors e = sheet_errors(height, 0.3, 3.0 / 16, 5);
    plain.push_back({double(height), e.plain});
    corrected.push_back({double(height), e.corrected});
    EXPECT_LT(e.plain, e.corrected);
    EXPECT_LT(std::abs(e.corrected), 0.6 * std::abs(e.plain));
  }
  for (const double order : test::print_orders("sheet, viscosity ratio 5, plain", plain))
    EXPECT_NEAR(order, 1.0, 0.15);
  for (const double order : test::print_orders("sheet, viscosity ratio 5, corrected", corrected))
    EXPECT_NEAR(order, 1.0, 0.3);
}

INSTANTIATE_TEST_SUITE_P(MagicParameter, Sheet, testing::Values(1.0 / 12, 3.0 / 16, 0.25));

}  // namespace
}  // namespace dld
