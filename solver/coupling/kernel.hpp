#pragma once
/// Immersed-boundary kernels in one dimension: phi2 (hat), phi3 (Roma, Peskin and Berger 1999), phi4 (Peskin
/// 2002). All have unit sum and zero first moment over the lattice.
#include <array>
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

/// What a kernel takes from the velocity of a membrane with the tangential load t (force / area) on a fluid
/// of viscosity eta, in units of dx^2 F / eta, F being the spread load interpolated back. Across the membrane
/// the tangential velocity falls off as t |z| / (2 eta) on both sides; spreading and interpolating round off
/// that kink and take t dx / (2 eta) sum_ij phi_i phi_j |i - j| from its top, while F = t / dx sum_i phi_i^2.
/// phi4: 1.016 and everywhere within 2 per cent of it.
template <class Phi>
double kink_share() {
  constexpr int positions = 64;  // of the membrane between two nodes: the mean over them is taken
  double rounded = 0, load = 0;
  for (int n = 0; n < positions; ++n) {
    std::array<double, Phi::width> w;
    Phi::weights((n + 0.5) / positions, w.data());
    for (int i = 0; i < Phi::width; ++i) {
      load += w[i] * w[i] / positions;
      for (int j = 0; j < i; ++j) rounded += w[i] * w[j] * (i - j) / positions;
    }
  }
  return rounded / load;
}

/// What the lattice takes on top of it, in the same units: the velocity of a flow along a lattice plane that
/// is driven by F(z) is that of the three-point Laplacian less (1/4 - 2 magic/3) F dx^2 / eta, magic being
/// the magic parameter of TRT, (tau - 1/2)^2 for BGK. Found with a sheet at four values of it, exact to five
/// digits.
inline double lattice_kink_share(double magic_parameter) {
  return 0.25 - 2.0 / 3.0 * magic_parameter;
}

inline Kernel kernel_by_name(const std::string& name) {
  if (name == "phi2") return Kernel::phi2;
  if (name == "phi3") return Kernel::phi3;
  if (name.starts_with("phi4")) return Kernel::phi4;
  throw std::invalid_argument("unknown kernel: " + name);
}

/// What a kernel of that name gives back for the spread load F at a node, in units of dx^2 F / eta_outside:
/// nothing, or what one fluid of the mean viscosity of both sides loses (phi4_corrected).
inline double kernel_correction(const std::string& name, double viscosity_ratio, double magic_parameter) {
  if (name != "phi4_corrected") return 0.0;
  return (kink_share<Phi4>() + lattice_kink_share(magic_parameter)) / (0.5 * (1 + viscosity_ratio));
}

}  // namespace dld
