#pragma once
/// Bending of two triangles hinged at an edge, E = c kB (theta - theta0)^2 per edge; c by bending_law.hpp.
/// theta is the angle between the outward normals, positive where the surface is convex. With the faces
/// (1,2,3) and (2,1,4), their area normals n and m and e = x2 - x1,
///   sin theta ~ e.(n x m),  cos theta ~ |e| n.m  (common factor |e| |n| |m|),
///   dtheta/dx3 = -|e| n/|n|^2, dtheta/dx4 = -|e| m/|m|^2, and the edge's ends balance force and torque.
/// Seen from one face with the edge vectors u_k opposite to its corners k, that gradient is
/// -(n/|n|^2) u_j.u_k / |e| at corner j: the face needs one number per edge, the hinge moment.
#include <cmath>
#include <numbers>

#include "membrane/vec3.hpp"

namespace dld {

/// Sine and cosine of an angle.
struct Angle {
  double sine, cosine;
};

/// atan2 without branches or table, so that loops with it vectorise; absolute error below 1e-15.
/// The argument is reduced to |t| <= tan(pi/8), where atan(t)/t is a minimax polynomial in t^2.
inline double branch_free_atan2(double y, double x) {
  constexpr double tan_pi_8 = 0.41421356237309503, tan_3pi_8 = 2.4142135623730949;
  constexpr double pi = std::numbers::pi;
  const double ax = std::abs(x), ay = std::abs(y);
  const bool steep = ay > tan_3pi_8 * ax, middle = ay > tan_pi_8 * ax;
  const double numerator = steep ? -ax : (middle ? ay - ax : ay);
  const double denominator = steep ? ay : (middle ? ay + ax : ax);
  const double offset = steep ? pi / 2 : (middle ? pi / 4 : 0.0);
  const double t = numerator / denominator, z = t * t;
  double p = 0.021133752033748363;
  p = p * z - 0.043479198390465370;
  p = p * z + 0.056883034036332498;
  p = p * z - 0.066402251735395008;
  p = p * z + 0.076899524882330162;
  p = p * z - 0.090907730032408278;
  p = p * z + 0.11111106177375227;
  p = p * z - 0.14285714180900645;
  p = p * z + 0.19999999998854167;
  p = p * z - 0.33333333333328434;
  const double angle = offset + (t + t * z * p);
  return std::copysign(x < 0 ? pi - angle : angle, y);
}

/// Sine and cosine of theta, both times |e| |n| |m|.
inline Angle scaled_dihedral(Vec3 e, Vec3 n, Vec3 m) {
  return {dot(e, cross(n, m)), std::sqrt(dot(e, e)) * dot(n, m)};
}

/// theta - theta0 in (-pi, pi], free of wrap-around, from the sine and cosine of theta0.
inline double bending_angle(Vec3 e, Vec3 n, Vec3 m, Angle theta0) {
  const auto [s, c] = scaled_dihedral(e, n, m);
  return branch_free_atan2(s * theta0.cosine - c * theta0.sine, c * theta0.cosine + s * theta0.sine);
}

/// Energy of a hinge; stiffness = c kB.
inline double hinge_energy(double stiffness, Vec3 e, Vec3 n, Vec3 m, Angle theta0) {
  const double angle = bending_angle(e, n, m, theta0);
  return stiffness * angle * angle;
}

/// Hinge moment -(dE/dtheta) per edge length: 2 c kB (theta - theta0) / |e|, with the sign of the force along
/// the outward normal on the opposite corners; stiffness = c kB.
inline double hinge_moment(double stiffness, Vec3 e, Vec3 n, Vec3 m, Angle theta0) {
  return 2 * stiffness * bending_angle(e, n, m, theta0) / std::sqrt(dot(e, e));
}

/// Forces on the corners 2 and 3 of one face from the hinges at its three edges (the first corner takes
/// the opposite of their sum): f_j = (n/|n|^2) u_j . w with w = sum_k moment_k u_k; a = x2 - x1, b = x3 - x1.
struct HingeForces {
  Vec3 f2, f3;
};

inline HingeForces hinge_forces(Vec3 a, Vec3 b, Vec3 n, double moment1, double moment2, double moment3) {
  const Vec3 u1 = b - a;
  const Vec3 w = moment1 * u1 - moment2 * b + moment3 * a;
  const Vec3 direction = (1 / dot(n, n)) * n;
  return {-dot(b, w) * direction, dot(a, w) * direction};
}

}  // namespace dld
