#pragma once
/// Area and volume of a closed surface of triangles, their gradients and penalties.
/// Each face has the area normal n = (x2 - x1) x (x3 - x1), |n| = 2 A, and adds x1.n / 6 to the volume.
/// On a closed surface dV/dx of a vertex is the sum of n / 6 over its faces.
#include <cmath>

#include "membrane/vec3.hpp"

namespace dld {

inline double face_area(Vec3 normal) {
  return 0.5 * std::sqrt(dot(normal, normal));
}

/// Signed volume of the tetrahedron of the face and the origin; x1 is its first corner.
inline double face_volume(Vec3 x1, Vec3 normal) {
  return dot(x1, normal) / 6;
}

/// Share of one face in dV/dx of each of its corners, per area normal.
constexpr double volume_gradient_per_normal = 1.0 / 6;

/// Energy (K/2)(q - q0)^2 / q0 of a global quantity q (area or volume).
inline double penalty_energy(double modulus, double q, double q0) {
  return 0.5 * modulus * (q - q0) * (q - q0) / q0;
}

/// Its derivative by q: a tension for the area, minus a pressure for the volume.
inline double penalty_derivative(double modulus, double q, double q0) {
  return modulus * (q - q0) / q0;
}

}  // namespace dld
