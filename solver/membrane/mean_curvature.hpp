#pragma once
/// Bending by the mean curvature at the nodes (Juelicher, J. Phys. II France 6, 1996):
///   E = (kB/2) sum over nodes of (m - m0)^2 A0,   m = 2H = S / (2 A),
/// S the sum of |e| theta over the node's edges (theta between the outward normals, positive where convex), A
/// a third of the area of its faces, m0 and A0 those of the rest shape. With q = kB (m - m0) A0 / A of a
/// node,
///   dE = sum over nodes of (q / 2) dS - q m dA:
/// a hinge of moment (q1 + q2)/2 per length, a pull along the edge, and a tension of each face.
#include <cmath>

#include "membrane/constraints.hpp"
#include "membrane/vec3.hpp"

namespace dld {

/// Twice the mean curvature of a node.
inline double twice_mean_curvature(double edge_sum, double area) {
  return edge_sum / (2 * area);
}

inline double mean_curvature_energy(double modulus, double m, double m0, double area0) {
  return 0.5 * modulus * (m - m0) * (m - m0) * area0;
}

/// q of a node.
inline double curvature_stress(double modulus, double m, double m0, double area, double area0) {
  return modulus * (m - m0) * area0 / area;
}

/// Forces on the corners 2 and 3 of a face with the sides a = x2 - x1 and b = x3 - x1 and the area normal n,
/// from the pull of its edges, -p_k u_k at the end of edge k (u1 = b - a, u2 = b, u3 = a), and its tension,
/// -t dA/dx. The first corner takes the opposite of their sum.
struct CurvatureForces {
  Vec3 f2, f3;
};

inline CurvatureForces curvature_forces(Vec3 a, Vec3 b, Vec3 n, double p1, double p2, double p3,
                                        double tension) {
  const Vec3 u1 = b - a;
  const Vec3 half_normal = (0.5 * tension / std::sqrt(dot(n, n))) * n;  // dA/dx2 = b x n / (2 |n|)
  return {p1 * u1 - p3 * a - cross(b, half_normal), -p1 * u1 - p2 * b - cross(half_normal, a)};
}

}  // namespace dld
