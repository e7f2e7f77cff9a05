/// Drag of arrays of cylinders and spheres.
#include <gtest/gtest.h>

#include "support/periodic_drag.hpp"

namespace dld {
namespace {

using test::cylinder_cell;
using test::measured_drag;

double area_fraction(int n, double r) {
  return std::numbers::pi * r * r / (n * n);
}

TEST(CylinderArray, DragIsThatOfSanganiAndAcrivos) {
  std::printf("%12s %6s %6s %8s %10s %10s %9s\n", "walls", "n", "R", "c", "measured", "series", "error");
  for (const auto& [n, r] : {std::pair{40, 6.1}, {40, 8.2}, {40, 11.0}}) {
    for (const auto walls : {WallModel::interpolated, WallModel::half_way}) {
      FluidModel model;
      model.walls = walls;
      const double exact = test::cylinder_drag(area_fraction(n, r));
      // A staircase has the radius at which its area is that of the circle: compare at the solid fraction.
      const UnitCell cell = cylinder_cell(n, r);
      const double drag = measured_drag(cell, model, 1e-8), error = drag / exact - 1;
      const bool interpolated = walls == WallModel::interpolated;
      std::printf("%12s %6d %6.1f %8.4f %10.4f %10.4f %9.4f\n", interpolated ? "interpolated" : "half-way", n,
                  r, area_fraction(n, r), drag, exact, error);
      EXPECT_LT(std::abs(error), interpolated ? 0.01 : 0.03);
    }
  }
}

TEST(SphereArray, DragIsThatOfHasimoto) {
  std::printf("%6s %6s %8s %10s %10s %9s\n", "n", "R", "c", "measured", "series", "error");
  for (const auto& [n, r] : {std::pair{20, 3.2}, {20, 4.6}}) {
    const double c = 4 * std::numbers::pi / 3 * r * r * r / (n * n * n);
    const double exact = 6 * std::numbers::pi * r * test::sphere_drag_factor(c);
    const double drag = measured_drag(test::sphere_cell(n, r), FluidModel{}, 1e-6);
    std::printf("%6d %6.1f %8.4f %10.4f %10.4f %9.4f\n", n, r, c, drag, exact, drag / exact - 1);
    EXPECT_NEAR(drag / exact, 1, 0.02);
  }
}

}  // namespace
}  // namespace dld
