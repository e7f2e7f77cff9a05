/// Rectangular duct of the gap's proportions 30 : 12 against the series, and its mirror symmetries.
#include "support/duct.hpp"

#include <gtest/gtest.h>

#include "support/convergence.hpp"

namespace dld {
namespace {

using test::duct_cell;

struct DuctErrors {
  double mean = 0;     ///< of the flow rate, relative
  double largest = 0;  ///< of the velocity, relative to the centre's
  double asymmetry = 0;
};

DuctErrors duct_errors(int width, int height, const FluidModel& model) {
  const UnitCell cell = duct_cell(width, height);
  const Lattice<double> lattice = test::steady_duct(cell, model, 1e-6, 1e-10);
  const double f_over_nu = 1e-6 / test::viscosity(model);
  const double centre = test::duct_velocity(0, 0, width, height, f_over_nu);
  double flow = 0;
  DuctErrors e;
  test::for_fluid_nodes(cell, [&](int x, int y, int z) {
    if (x != 0) return;
    const double u = lattice.moments(0, y, z)[1];
    const double exact = test::duct_velocity(y + cell.origin_y, z + cell.origin_z, width, height, f_over_nu);
    e.largest = std::max(e.largest, std::abs(u - exact) / centre);
    for (const double image :
         {lattice.moments(0, cell.ny - 1 - y, z)[1], lattice.moments(0, y, height - 1 - z)[1]}) {
      e.asymmetry = std::max(e.asymmetry, std::abs(u - image) / centre);
    }
    flow += u;
  });
  // Exact flow rate of the plane channel less the effect of the two sides.
  constexpr double pi = std::numbers::pi;
  double sides = 0;
  for (int n = 1; n < 400; n += 2) sides += std::tanh(n * pi * width / (2.0 * height)) / std::pow(n, 5);
  const double exact_flow =
      f_over_nu * std::pow(height, 3) * width / 12 * (1 - 192.0 * height / (std::pow(pi, 5) * width) * sides);
  e.mean = flow / exact_flow - 1;
  return e;
}

TEST(Duct, ConvergesAtSecondOrder) {
  std::vector<test::Level> flow, largest;
  for (const int height : {6, 12, 24}) {
    const DuctErrors e = duct_errors(height * 5 / 2, height, FluidModel{});
    flow.push_back({double(height), e.mean});
    largest.push_back({double(height), e.largest});
    EXPECT_LT(e.asymmetry, 1e-12);
  }
  const auto flow_orders = test::print_orders("duct 30:12, flow rate against H", flow);
  const auto largest_orders = test::print_orders("duct 30:12, largest error against H", largest);
  EXPECT_LT(std::abs(flow[1].error), 5e-3);
  EXPECT_LT(largest[1].error, 5e-3);
  for (const double order : flow_orders) EXPECT_NEAR(order, 2, 0.3);
  for (const double order : largest_orders) EXPECT_GT(order, 1.7);
}

}  // namespace
}  // namespace dld
