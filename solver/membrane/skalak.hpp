#pragma once
/// In-plane elasticity of one triangle with linear shape functions (Skalak et al., Biophys. J. 13, 1973).
/// Energy per reference area, with I1 = tr C - 2 and I2 = det C - 1 of the Cauchy-Green tensor C:
///   W = (kS/k)(I1^2 + 2 I1 - 2 I2) + (kalpha/12) I2^2.
/// With the edges a = x2 - x1, b = x3 - x1, the metric g = [a.a a.b; a.b b.b] and its reference g0,
///   tr C = tr(g0^-1 g),  det C = det g / det g0,
/// so no local frame is needed and rigid motions drop out by construction.
#include <cmath>

#include "membrane/vec3.hpp"

namespace dld {

/// Undeformed triangle: inverse metric h = g0^-1 and area A0 = sqrt(det g0) / 2.
struct ReferenceTriangle {
  double h11, h12, h22, area;
};

struct SkalakModuli {
  double shear;       ///< kS / k
  double dilatation;  ///< kalpha / 12
};

struct StrainInvariants {
  double i1, i2;
};

/// Forces on the second and third corner; the first one takes the opposite of their sum.
struct TriangleForces {
  Vec3 f2, f3;
};

inline ReferenceTriangle reference_triangle(Vec3 a, Vec3 b) {
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b);
  const Vec3 n = cross(a, b);
  const double det = dot(n, n);
  return {bb / det, -ab / det, aa / det, 0.5 * std::sqrt(det)};
}

inline StrainInvariants strain_invariants(const ReferenceTriangle& ref, double aa, double ab, double bb) {
  const double det0 = 4 * ref.area * ref.area;
  return {ref.h11 * aa + 2 * ref.h12 * ab + ref.h22 * bb - 2, (aa * bb - ab * ab) / det0 - 1};
}

/// Energy of the triangle (its reference area times W).
inline double skalak_energy(const ReferenceTriangle& ref, const SkalakModuli& m, Vec3 a, Vec3 b) {
  const auto [i1, i2] = strain_invariants(ref, dot(a, a), dot(a, b), dot(b, b));
  return ref.area * (m.shear * (i1 * i1 + 2 * i1 - 2 * i2) + m.dilatation * i2 * i2);
}

/// Corner forces -d(A0 W)/dx plus those of an isotropic `tension` (energy tension * A). The area is
/// A = A0 sqrt(1 + I2), so the tension enters as dW/dI2 = tension / (2 A / A0).
inline TriangleForces skalak_forces(const ReferenceTriangle& ref, const SkalakModuli& m, double tension,
                                    Vec3 a, Vec3 b) {
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b);
  const double det = aa * bb - ab * ab, det0 = 4 * ref.area * ref.area;
  const auto [i1, i2] = strain_invariants(ref, aa, ab, bb);
  const double w1 = m.shear * (2 * i1 + 2);
  const double w2 = -2 * m.shear + 2 * m.dilatation * i2 + tension * ref.area / std::sqrt(det);
  const double s1 = -2 * ref.area * w1, s2 = -2 * ref.area * w2 / det0;
  const double c11 = s1 * ref.h11 + s2 * bb, c12 = s1 * ref.h12 - s2 * ab, c22 = s1 * ref.h22 + s2 * aa;
  return {c11 * a + c12 * b, c12 * a + c22 * b};
}

/// Tensions of a face, force per deformed length: mean (t1 + t2) / 2 and shear |t1 - t2| / 2 of the two
/// principal ones.
struct FaceTensions {
  double mean, shear;
};

/// Cauchy tension T = (2 / J) F (dW/dC) F^T with J = A / A0, whose principal values are
///   t = (2 / J) (W1 c + W2 J^2),  W1 = dW/dI1,  W2 = dW/dI2,  c the eigenvalues of C,
/// plus an isotropic `tension`.
inline FaceTensions skalak_tensions(const ReferenceTriangle& ref, const SkalakModuli& m, double tension,
                                    Vec3 a, Vec3 b) {
  const auto [i1, i2] = strain_invariants(ref, dot(a, a), dot(a, b), dot(b, b));
  const double trace = i1 + 2, det = i2 + 1, stretch = std::sqrt(det);
  const double w1 = m.shear * (2 * i1 + 2), w2 = -2 * m.shear + 2 * m.dilatation * i2;
  const double discriminant = trace * trace - 4 * det;  // (c1 - c2)^2, not below zero but for rounding
  return {(w1 * trace + 2 * w2 * det) / stretch + tension,
          w1 * std::sqrt(discriminant > 0 ? discriminant : 0) / stretch};
}

}  // namespace dld
