#pragma once
/// How easily fluid passes the array: an estimate from the depth-averaged flow, before anything is simulated.
///
///   -grad p + eta (laplace u - 12 u / H^2) + f = 0,  div u = 0     (Brinkman; Hele-Shaw with pillars)
///   u = 0 on the pillars,  u(x + lambda, y) = u(x, y - d)
///
/// The parabola across the depth H is assumed everywhere; where the depth is not small against the gap, the
/// mean is corrected for the flat profile between pillars. Against the flow of the solver the mean velocity
/// is right within `friction_uncertainty` for depths of 4.8 to 48 um at a pitch of 32 um and pillar fractions
/// of 0.1 to 0.7 (tests/physics/friction_test.cpp).
#include <functional>

namespace dld {

/// Relative error of the mean velocity, at the most seen.
constexpr double friction_uncertainty = 0.06;

/// One unit cell of the array, in any unit of length.
struct ArrayGeometry {
  double pitch_x = 0, pitch_y = 0, row_shift = 0, depth = 0;
  double gap = 0;  ///< narrowest way between two pillars: what the grid has to resolve
  /// Signed distance from the nearest pillar, negative inside; (0, 0) is the centre of one.
  std::function<double(double x, double y)> distance;
};

/// Mean velocity over the fluid, u = M f / eta, for a force f per volume; M in units of length squared.
struct Mobility {
  double xx = 0, xy = 0, yx = 0, yy = 0;
  double open_area = 1;  ///< share of the fluid in the cell
  double largest = 0;    ///< largest velocity in the mid plane under a force along x, the same units

  /// Mean velocity along x while the mean velocity along y is held at zero by a force.
  double blocked() const { return xx - xy * yx / yy; }
  /// Mean velocity along y over that along x, under a force along x.
  double lateral_ratio() const { return yx / xx; }
};

/// Solves the depth-averaged flow on about 24 to 48 cells a side: 5 to 40 ms.
Mobility estimate_mobility(const ArrayGeometry& array);

/// The slit without pillars: H^2 / 12.
Mobility slit_mobility(double depth);

}  // namespace dld
