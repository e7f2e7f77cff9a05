/// Immersed-boundary kernels against their printed form, and their sums.
#include "coupling/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace dld {
namespace {

/// The kernels as they are printed, r = distance in lattice spacings (Roma, Peskin and Berger 1999; Peskin
/// 2002).
double printed_phi2(double r) {
  return std::max(0.0, 1 - std::abs(r));
}
double printed_phi3(double r) {
  r = std::abs(r);
  if (r <= 0.5) return (1 + std::sqrt(1 - 3 * r * r)) / 3;
  if (r <= 1.5) return (5 - 3 * r - std::sqrt(-2 + 6 * r - 3 * r * r)) / 6;
  return 0;
}
double printed_phi4(double r) {
  r = std::abs(r);
  if (r <= 1) return (3 - 2 * r + std::sqrt(1 + 4 * r - 4 * r * r)) / 8;
  if (r <= 2) return (5 - 2 * r - std::sqrt(-7 + 12 * r - 4 * r * r)) / 8;
  return 0;
}

template <class Phi>
void check_kernel(double (*printed)(double)) {
  for (double s = -3.0; s < 3.0; s += 0.0137) {
    std::array<double, Phi::width> w{};
    Phi::weights(s, w.data());
    double sum = 0, moment = 0;
    for (int k = 0; k < Phi::width; ++k) {
      const double r = Phi::first(s) + k - s, weight = w[static_cast<std::size_t>(k)];
      EXPECT_NEAR(weight, printed(r),
                  1e-7);  // the root makes the printed outer branch ill-conditioned at its end
      sum += weight;
      moment += weight * r;
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_NEAR(moment, 0, 1e-14);
  }
}

TEST(Kernel, WeightsAreThePrintedOnesWithUnitSumAndNoFirstMoment) {
  check_kernel<Phi2>(printed_phi2);
  check_kernel<Phi3>(printed_phi3);
  check_kernel<Phi4>(printed_phi4);
}

/// Peskin's condition: the sum of phi^2 does not depend on the place (1/2 for phi3, 3/8 for phi4).
TEST(Kernel, SumOfSquaresIsConstant) {
  for (double s = 0; s < 1; s += 0.013) {
    std::array<double, 4> w{};
    Phi3::weights(s, w.data());
    EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2], 0.5, 1e-14);
    Phi4::weights(s, w.data());
    EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3], 0.375, 1e-14);
  }
}

/// By hand: phi4 has the weights 1/4, 1/2, 1/4 on a node, phi2 1 on a node and 1/2, 1/2 between two.
TEST(Kernel, ShareOfTheKink) {
  EXPECT_NEAR(kink_share<Phi4>(), 1.0, 0.02);
  EXPECT_GT(kink_share<Phi4>(), 1.0);  // 0.375 / 0.375 on a node, more between nodes
  EXPECT_NEAR(kink_share<Phi3>(), 0.53, 0.03);
  // phi2: sum_ij phi_i phi_j |i - j| / 2 = t (1 - t), sum phi^2 = 1 - 2 t (1 - t): means 1/6 and 2/3.
  EXPECT_NEAR(kink_share<Phi2>(), 0.25, 1e-4);
}

TEST(Kernel, CorrectionIsOfTheMeanViscosity) {
  const double magic = 0.1, share = kink_share<Phi4>() + lattice_kink_share(magic);
  EXPECT_DOUBLE_EQ(kernel_correction("phi4", 5, magic), 0.0);
  EXPECT_DOUBLE_EQ(kernel_correction("phi4_corrected", 1, magic), share);
  EXPECT_DOUBLE_EQ(kernel_correction("phi4_corrected", 5, magic), share / 3);
}

}  // namespace
}  // namespace dld
