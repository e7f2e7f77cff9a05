/// Drag of arrays of cylinders and spheres.
#include <gtest/gtest.h>

#include "support/periodic_drag.hpp"

namespace dld {
namespace {

using test::cylinder_cell;
using test::measured_drag;

constexpr double pi = std::numbers::pi;

/// F / (mu U) of the cylinder array at area fraction c; R in units of the pitch follows from c.
double cylinder_error(int n, double c, WallModel walls, double exact) {
  FluidModel model;
  model.walls = walls;
  const double r = n * std::sqrt(c / pi), drag = measured_drag(cylinder_cell(n, r), model, 1e-8);
  const bool interpolated = walls == WallModel::interpolated;
  std::printf("%12s %5d %7.3f %6.2f %10.4f %10.4f %9.4f\n", interpolated ? "interpolated" : "half-way", n, r,
              c, drag, exact, drag / exact - 1);
  return drag / exact - 1;
}

TEST(CylinderArray, DragIsThatOfSanganiAndAcrivos) {
  std::printf("%12s %5s %7s %6s %10s %10s %9s\n", "walls", "n", "R", "c", "measured", "reference", "error");
  struct Reference {
    double c, drag;
  };
  // Dilute series where it holds; beyond, table 1 of the same paper.
  for (const auto& [c, drag] :
       {Reference{0.05, test::cylinder_drag(0.05)}, Reference{0.1, test::cylinder_drag(0.1)},
        Reference{0.2, 51.53}, Reference{0.3, 102.90}, Reference{0.4, 217.89}}) {
    EXPECT_LT(std::abs(cylinder_error(60, c, WallModel::interpolated, drag)), 0.01);
  }
  // The staircase at the device's own resolution, R = 25 lu and c = 0.307.
  EXPECT_LT(std::abs(cylinder_error(80, 0.3, WallModel::half_way, 102.90)), 0.03);
  EXPECT_LT(std::abs(cylinder_error(80, 0.3, WallModel::interpolated, 102.90)), 0.005);
}

TEST(SphereArray, DragIsThatOfHasimoto) {
  std::printf("%6s %6s %8s %10s %10s %9s\n", "n", "R", "c", "measured", "series", "error");
  constexpr double ratio = 0.1634, c = 4 * pi / 3 * ratio * ratio * ratio;
  std::vector<double> errors;
  for (const int n : {16, 28}) {
    const double exact = 6 * pi * ratio * n * test::sphere_drag_factor(c);
    const double drag = measured_drag(test::sphere_cell(n, ratio * n), FluidModel{}, 1e-6);
    errors.push_back(std::abs(drag / exact - 1));
    std::printf("%6d %6.2f %8.4f %10.4f %10.4f %9.4f\n", n, ratio * n, c, drag, exact, drag / exact - 1);
  }
  EXPECT_LT(errors[1], 0.02);
  EXPECT_LT(errors[1], 0.7 * errors[0]);
}

}  // namespace
}  // namespace dld
