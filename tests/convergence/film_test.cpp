/// A flat membrane between two fluids and two walls under a load that varies along it, (f_t sin q x, 0,
/// f_n cos q x), against the exact Stokes flow of the two layers: the film between a cell and a pillar with
/// its shear, its pressure and its motion across. The coupling does what CoupledCell does.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>

#include "coupling/immersed_boundary.hpp"
#include "support/convergence.hpp"
#include "support/fluid_box.hpp"

namespace dld {
namespace {

struct Load {
  double along = 0, across = 0;  ///< f_t, f_n
};

/// Amplitudes of the membrane's velocity (u_t sin q x, 0, u_n cos q x).
struct Motion {
  double along = 0, across = 0;
};

/// In a layer u_z = w(z) cos q x with w = (a + b z) cosh q z + (c + d z) sinh q z, u_x = -(w'/q) sin q x and
/// p = eta (w''' / q^2 - w') cos q x; w and w' vanish at the walls and are continuous at z = 0, where the
/// load makes the stresses jump.
Motion exact_motion(double above, double below, double eta, double ratio, double q, Load load) {
  const auto row = [q](double z, int derivative) {  // of the four parts of w
    const bool even = derivative % 2 == 0;
    const double cosh = even ? std::cosh(q * z) : std::sinh(q * z);
    const double sinh = even ? std::sinh(q * z) : std::cosh(q * z);
    const double power = std::pow(q, derivative), lower = derivative * std::pow(q, derivative - 1);
    return Eigen::RowVector4d(power * cosh, z * power * cosh + lower * sinh, power * sinh,
                              z * power * sinh + lower * cosh);
  };
  const auto shear = [&](double viscosity) { return (viscosity * (-row(0, 2) / q - q * row(0, 0))).eval(); };
  const auto normal = [&](double viscosity) {  // 2 eta w' - p
    return (viscosity * (3 * row(0, 1) - row(0, 3) / (q * q))).eval();
  };
  Eigen::Matrix<double, 8, 8> m = Eigen::Matrix<double, 8, 8>::Zero();
  Eigen::Matrix<double, 8, 1> b = Eigen::Matrix<double, 8, 1>::Zero();
  for (int d = 0; d < 2; ++d) {
    m.block<1, 4>(d, 0) = row(above, d);
    m.block<1, 4>(2 + d, 4) = row(-below, d);
    m.block<1, 4>(4 + d, 0) = row(0, d);
    m.block<1, 4>(4 + d, 4) = -row(0, d);
  }
  m.block<1, 4>(6, 0) = shear(eta);
  m.block<1, 4>(6, 4) = -shear(ratio * eta);
  m.block<1, 4>(7, 0) = normal(eta);
  m.block<1, 4>(7, 4) = -normal(ratio * eta);
  b(6) = -load.along;
  b(7) = -load.across;
  const Eigen::Vector4d layer = m.partialPivLu().solve(b).head<4>();
  return {-row(0, 1).dot(layer) / q, row(0, 0).dot(layer)};
}

constexpr double magic = 3.0 / 16;

/// The membrane lies at z (lattice spacings from the middle), the outer fluid above it; share: what is given
/// back of the spread load, dx^2 F / eta.
Motion coupled_motion(int height, double z, double ratio, Load load, double share) {
  const int length = 2 * height;
  constexpr int width = 4;
  const test::BoxSize size{length, width, height, 0, 0, HeightBoundary::walls};
  const FluidModel model;
  Lattice<double> lattice(test::unit_cell(size), model);
  const double eta = (model.relaxation_time - 0.5) / 3, q = 2 * std::numbers::pi / length;
  test::set_relaxation_time_below(lattice, size, z, 0.5 + 3 * ratio * eta);
  const int n = 4 * length * width;  // two nodes for a spacing
  Eigen::MatrixX3d x(n, 3), force = Eigen::MatrixX3d::Zero(n, 3), u(n, 3), f(n, 3);
  for (int i = 0; i < 2 * length; ++i) {
    for (int j = 0; j < 2 * width; ++j) {
      const int at = i * 2 * width + j;
      x.row(at) << 0.5 * i, 0.5 * j, z;
      force(at, 0) = 0.25 * load.along * std::sin(q * x(at, 0));
      force(at, 2) = 0.25 * load.across * std::cos(q * x(at, 0));
    }
  }
  ImmersedBoundary<double> boundary(lattice, Kernel::phi4, coupled_nodes(x, false));
  boundary.locate(x, std::vector<std::uint8_t>(static_cast<std::size_t>(n), 0));
  boundary.spread(force);
  const int steps = static_cast<int>(1.6 * height * height / eta);
  for (int k = 0; k < steps; ++k) lattice.step(boundary.active());
  boundary.interpolate(u);
  boundary.interpolate_force(f);
  Motion motion;
  for (int i = 0; i < n; ++i) {
    motion.across += 2.0 / n * std::cos(q * x(i, 0)) * u(i, 2);
    motion.along += 2.0 / n * std::sin(q * x(i, 0)) * (u(i, 0) + share / eta * f(i, 0));
  }
  return motion;
}

/// Mean over places of the membrane between two lattice planes of the error, by the larger velocity.
Motion mean_error(int height, double ratio, Load load, double share) {
  constexpr int places = 2;
  const double eta = (FluidModel{}.relaxation_time - 0.5) / 3;
  Motion mean;
  for (int k = 0; k < places; ++k) {
    const double z = 0.25 * height + (k + 0.5) / places - 0.5;
    const Motion exact =
        exact_motion(0.5 * height - z, 0.5 * height + z, eta, ratio, std::numbers::pi / height, load);
    const Motion got = coupled_motion(height, z, ratio, load, share);
    const double scale = std::max(std::abs(exact.along), std::abs(exact.across));
    mean.along += (got.along - exact.along) / scale / places;
    mean.across += (got.across - exact.across) / scale / places;
  }
  return mean;
}

struct Errors {
  std::vector<test::Level> along, across;
  double order_along = 0, order_across = 0;  ///< between the finest two levels
};

Errors errors(double ratio, Load load, double share, const char* title) {
  Errors e;
  for (const int height : {8, 16, 32}) {
    const Motion mean = mean_error(height, ratio, load, share);
    e.along.push_back({double(height), mean.along});
    e.across.push_back({double(height), mean.across});
  }
  std::printf("viscosity ratio %g, %s load, %s\n", ratio, load.along > 0 ? "tangential" : "normal", title);
  e.order_along = test::print_orders("velocity along", e.along).back();
  e.order_across = test::print_orders("velocity across", e.across).back();
  return e;
}

constexpr Load tangential_load{1e-5, 0}, normal_load{0, 1e-5};

TEST(Film, InOneFluidTheCorrectedKernelIsOfSecondOrder) {
  for (const Load load : {tangential_load, normal_load}) {
    const Errors e = errors(1, load, kernel_correction("phi4_corrected", 1, magic), "corrected");
    EXPECT_GT(e.order_along, 1.7);
    EXPECT_GT(e.order_across, 1.7);
    EXPECT_LT(std::abs(e.along.back().error), 0.02);
    EXPECT_LT(std::abs(e.across.back().error), 0.025);
  }
}

/// What the mean viscosity leaves of the error of first order.
TEST(Film, BetweenTwoFluidsTheCorrectedKernelTakesAwayMostOfTheError) {
  const Errors plain = errors(5, tangential_load, 0, "plain");
  const Errors corrected =
      errors(5, tangential_load, kernel_correction("phi4_corrected", 5, magic), "corrected");
  EXPECT_NEAR(plain.order_along, 1.0, 0.2);
  EXPECT_LT(std::abs(corrected.along.back().error), 0.5 * std::abs(plain.along.back().error));
}

}  // namespace
}  // namespace dld
