#pragma once
/// Short-range repulsion between membrane nodes and walls: f = K (1/h^2 - 1/h0^2) along the wall's normal for
/// h < h0, with h not below h_min (a quarter of h0, and of one at most). The law is a default of ours; the
/// paper gives only the range h0 = 1.
#include <algorithm>

namespace dld {

struct Repulsion {
  double strength = 0.0;                             ///< K, lattice units of force
  double range = 1.0;                                ///< h0, lattice spacings
  static constexpr double smallest_distance = 0.25;  ///< keeps the force finite; share of a range below one

  double force(double h) const {
    if (h >= range) return 0.0;
    const double d = std::max(h, smallest_distance * std::min(range, 1.0));
    return strength * (1.0 / (d * d) - 1.0 / (range * range));
  }
};

}  // namespace dld
