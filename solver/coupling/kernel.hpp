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

/// What a kernel does to a kink of the velocity at z = 0 when forces are spread from, and velocities taken
/// at, points that lie at z = retraction, inside (z > 0) a membrane whose two sides differ in viscosity. Sums
/// over the nodes i of either side with the weights phi_i, mean over the place of the membrane between the
/// nodes; lattice units.
struct KinkSums {
  double reach_outside = 0, reach_inside = 0;      ///< sum of phi_i |z_i|
  double rounded_outside = 0, rounded_inside = 0;  ///< sum over pairs of phi_i phi_j |z_i - z_j|, each once
  double load_outside = 0, load_inside = 0;        ///< sum of phi_i^2
};

template <class Phi>
KinkSums kink_sums(double retraction) {
  constexpr int positions = 64;
  KinkSums sums;
  for (int n = 0; n < positions; ++n) {
    const double membrane = (n + 0.5) / positions;
    std::array<double, Phi::width> w, z;
    Phi::weights(membrane + retraction, w.data());
    for (int i = 0; i < Phi::width; ++i) z[i] = Phi::first(membrane + retraction) + i - membrane;
    for (int i = 0; i < Phi::width; ++i) {
      const bool outside = z[i] < 0;
      (outside ? sums.reach_outside : sums.reach_inside) += w[i] * std::abs(z[i]) / positions;
      (outside ? sums.load_outside : sums.load_inside) += w[i] * w[i] / positions;
      for (int j = 0; j < i; ++j) {
        if ((z[j] < 0) == outside)
          (outside ? sums.rounded_outside : sums.rounded_inside) += w[i] * w[j] * (z[i] - z[j]) / positions;
      }
    }
  }
  return sums;
}

/// What a kernel takes from the velocity of a membrane with the tangential load t (force / area) on a fluid
/// of viscosity eta, in units of dx^2 F / eta, F being the spread load interpolated back. Across the membrane
/// the tangential velocity falls off as t |z| / (2 eta) on both sides; spreading and interpolating round off
/// that kink and take t dx / (2 eta) sum_ij phi_i phi_j |i - j| from its top, while F = t / dx sum_i phi_i^2.
/// phi4: 1.016 and everywhere within 2 per cent of it.
template <class Phi>
double kink_share() {
  const KinkSums s = kink_sums<Phi>(0);
  return (s.reach_outside + s.rounded_outside + s.rounded_inside) / (s.load_outside + s.load_inside);
}

/// What the lattice takes on top of it, in the same units: the velocity of a flow along a lattice plane that
/// is driven by F(z) is that of the three-point Laplacian less (1/4 - 2 magic/3) F dx^2 / eta, magic being
/// the magic parameter of TRT, (tau - 1/2)^2 for BGK. Found with a sheet at four values of it, exact to five
/// digits.
inline double lattice_kink_share(double magic_parameter) {
  return 0.25 - 2.0 / 3.0 * magic_parameter;
}

/// Correction of the kernel for a membrane between two viscosities.
struct JumpCorrection {
  double retraction = 0;  ///< of the points that carry the tangential load, lattice spacings into the cell
  double share = 0;       ///< given back, dx^2 F / eta_outside
};

/// For the ratio of the viscosities inside and outside. A load t that is smeared over both sides lets outer
/// and inner flow, continued to the membrane, differ by
///   t (reach_outside / eta_outside - reach_inside / eta_inside),
/// and the interpolated velocity then depends on the shear rates of both. The retraction that makes this
/// zero leaves a difference to the velocity of the membrane that follows from the load alone:
///   t ((reach_outside + rounded_outside + c load_outside) / eta_outside
///      + (rounded_inside + c load_inside) / eta_inside),      c = lattice_kink_share,
/// with t = F / (load_outside + load_inside). Ratio 1: no retraction, kink_share + c. Derived for a flat
/// sheet in shear flow with a sharp jump.
template <class Phi>
JumpCorrection jump_correction(double viscosity_ratio, double magic_parameter) {
  double low = -Phi::width, high = Phi::width;  // of the retraction: one side has all of the load
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    const KinkSums s = kink_sums<Phi>(middle);
    (s.reach_inside < viscosity_ratio * s.reach_outside ? low : high) = middle;
  }
  const double c = lattice_kink_share(magic_parameter), retraction = 0.5 * (low + high);
  const KinkSums s = kink_sums<Phi>(retraction);
  const double outside = s.reach_outside + s.rounded_outside + c * s.load_outside;
  const double inside = s.rounded_inside + c * s.load_inside;
  return {retraction, (outside + inside / viscosity_ratio) / (s.load_outside + s.load_inside)};
}

inline Kernel kernel_by_name(const std::string& name) {
  if (name == "phi2") return Kernel::phi2;
  if (name == "phi3") return Kernel::phi3;
  if (name.starts_with("phi4")) return Kernel::phi4;
  throw std::invalid_argument("unknown kernel: " + name);
}

/// What a kernel of that name gives back: nothing, what one fluid of the mean viscosity loses
/// (phi4_corrected), or what the two fluids lose (phi4_jump).
inline JumpCorrection kernel_correction(const std::string& name, double viscosity_ratio,
                                        double magic_parameter) {
  if (name == "phi4_corrected") {
    const double share = kink_share<Phi4>() + lattice_kink_share(magic_parameter);
    return {0, share / (0.5 * (1 + viscosity_ratio))};
  }
  if (name == "phi4_jump") return jump_correction<Phi4>(viscosity_ratio, magic_parameter);
  return {};
}

}  // namespace dld
