#pragma once
/// Tables of errors over refinement levels.
#include <cmath>
#include <cstdio>
#include <vector>

namespace dld::test {

struct Level {
  double size = 0;   ///< resolution: lattice spacings per length
  double error = 0;  ///< relative
};

/// Prints level, error and observed order between neighbours; returns the orders.
inline std::vector<double> print_orders(const char* title, const std::vector<Level>& levels) {
  std::printf("%s\n%10s %14s %8s\n", title, "level", "error", "order");
  std::vector<double> orders;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (k == 0) {
      std::printf("%10g %14.6e %8s\n", levels[k].size, levels[k].error, "");
      continue;
    }
    orders.push_back(std::log(std::abs(levels[k - 1].error / levels[k].error)) /
                     std::log(levels[k].size / levels[k - 1].size));
    std::printf("%10g %14.6e %8.2f\n", levels[k].size, levels[k].error, orders.back());
  }
  return orders;
}

}  // namespace dld::test
