#pragma once
/// The bending laws by name: what energy a bending modulus kB stands for. The paper does not print it.
///
/// Three laws are E = c kB sum over edges (theta - theta0)^2 with another prefactor c. A sum over hinges
/// carries a hidden Gaussian modulus of -4/3 of its bending modulus (Seung and Nelson, Phys. Rev. A 38,
/// 1988), so a sheet that is folded about one axis feels c sqrt(3) kB and a sphere bent from a flat sheet c
/// kB / sqrt(3): no c serves both. The fourth law is that of the nodal mean curvature (Juelicher, J. Phys. II
/// France 6, 1996).
#include <array>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dld {

enum class BendingLaw { hinge_sphere, hinge_half, hinge_sheet, mean_curvature };

struct BendingLawEntry {
  BendingLaw law;
  std::string_view name;
  double hinge_prefactor;  ///< c; 0: no sum over hinges
  double fold_ratio;       ///< modulus that a sheet bent about one axis feels, over kB
  double sphere_ratio;     ///< energy of a sphere bent from a flat sheet, over 8 pi kB
  /// Largest eigenvalue of the stiffness of the resting red cell over that with hinge_sphere, at equal kB:
  /// what explicit motion has to bear.
  double relative_stiffness;
};

/// The one list of laws.
constexpr std::array<BendingLawEntry, 4> bending_laws{{
    // Calibrated on the sphere: sqrt(3) sum theta^2 = 8 pi. An open code of this model has it (HemeLB, issue
    // 684, 2017).
    {BendingLaw::hinge_sphere, "hinge_sphere", std::numbers::sqrt3, 3.0, 1.0, 1.0},
    // A sphere with the Gaussian modulus -kB (Gompper and Kroll, J. Phys. I France 6, 1996).
    {BendingLaw::hinge_half, "hinge_half", std::numbers::sqrt3 / 2, 1.5, 0.5, 0.5},
    // Calibrated on a sheet (Seung and Nelson 1988): kB is the Helfrich modulus that a fold feels.
    {BendingLaw::hinge_sheet, "hinge_sheet", std::numbers::inv_sqrt3, 1.0, 1.0 / 3, 1.0 / 3},
    // (kB/2) sum over nodes of (2H - 2H0)^2 A0, A H = (1/4) sum over the node's edges of |e| theta.
    {BendingLaw::mean_curvature, "mean_curvature", 0.0, 1.0, 1.0, 0.45},
}};

constexpr const BendingLawEntry& entry(BendingLaw law) {
  return bending_laws[static_cast<std::size_t>(law)];
}

/// Throws std::invalid_argument for an unknown name.
inline BendingLaw bending_law_by_name(std::string_view name) {
  for (const auto& known : bending_laws) {
    if (known.name == name) return known.law;
  }
  throw std::invalid_argument("unknown bending law: " + std::string(name));
}

inline std::vector<std::string> bending_law_names() {
  std::vector<std::string> names;
  for (const auto& known : bending_laws) names.emplace_back(known.name);
  return names;
}

}  // namespace dld
