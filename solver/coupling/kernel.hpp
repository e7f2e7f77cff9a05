#pragma once
/// Immersed-boundary kernels in one dimension: phi2 (hat), phi3 (Roma, Peskin and Berger 1999), phi4 (Peskin
/// 2002). All have unit sum and zero first moment over the lattice.
#include <cmath>
#include <stdexcept>
#include <string>

namespace dld {

/// Weights on `width` neighbouring nodes; the first node is first(s) for a point at lattice coordinate s.
struct Phi2 {
  static constexpr int width = 2;
  static int first(double s) { return static_cast<int>(std::floor(s)); }
  static void weights(double s, double* w) {
    const double t = s - std::floor(s);
    w[0] = 1.0 - t;
    w[1] = t;
  }
};

struct Phi3 {
  static constexpr int width = 3;
  static int first(double s) { return static_cast<int>(std::floor(s + 0.5)) - 1; }
  static void weights(double s, double* w) {
    const double t = s - std::floor(s + 0.5);  // -1/2 <= t < 1/2, distance to the middle node
    w[1] = (1.0 + std::sqrt(1.0 - 3.0 * t * t)) / 3.0;
    // From the unit sum and the zero first moment: the printed outer branch gives the same numbers.
    w[0] = 0.5 * (1.0 - w[1] - t);
    w[2] = 0.5 * (1.0 - w[1] + t);
  }
};

struct Phi4 {
  static constexpr int width = 4;
  static int first(double s) { return static_cast<int>(std::floor(s)) - 1; }
  static void weights(double s, double* w) {
    const double t = s - std::floor(s);  // distance to the second node
    const double root = std::sqrt(1.0 + 4.0 * t - 4.0 * t * t);
    w[1] = (3.0 - 2.0 * t + root) / 8.0;
    w[2] = (1.0 + 2.0 * t + root) / 8.0;
    w[0] = (3.0 - 2.0 * t - root) / 8.0;
    w[3] = (1.0 + 2.0 * t - root) / 8.0;
  }
};

enum class Kernel { phi2, phi3, phi4 };

inline Kernel kernel_by_name(const std::string& name) {
  if (name == "phi2") return Kernel::phi2;
  if (name == "phi3") return Kernel::phi3;
  if (name == "phi4") return Kernel::phi4;
  throw std::invalid_argument("unknown kernel: " + name);
}

}  // namespace dld
