#pragma once
/// What the bending laws cost, for kB = 1: sheets of triangles rolled on a cylinder, spheres bent from a flat
/// sheet, and the resting red blood cell squeezed in its plane.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "membrane/bending.hpp"
#include "membrane/constraints.hpp"
#include "membrane/mean_curvature.hpp"
#include "membrane/membrane.hpp"

namespace dld::test {

/// Hexagon of equilateral triangles of unit edge in the plane z = 0, turned by an angle; its corners are
/// `rings` edges away from its centre.
inline TriangleMesh hexagon(int rings, double turn = 0) {
  const Eigen::RowVector3d a1(std::cos(turn), std::sin(turn), 0);
  const Eigen::RowVector3d a2(std::cos(turn + std::numbers::pi / 3), std::sin(turn + std::numbers::pi / 3),
                              0);
  std::map<std::pair<int, int>, int> index;
  for (int i = -rings; i <= rings; ++i) {
    for (int j = -rings; j <= rings; ++j) {
      if (std::abs(i + j) <= rings) index.emplace(std::pair{i, j}, static_cast<int>(index.size()));
    }
  }
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(index.size()), 3);
  std::vector<Eigen::RowVector3i> faces;
  const auto add = [&](std::pair<int, int> a, std::pair<int, int> b, std::pair<int, int> c) {
    if (index.contains(a) && index.contains(b) && index.contains(c))
      faces.emplace_back(index[a], index[b], index[c]);
  };
  for (const auto& [point, v] : index) {
    const auto [i, j] = point;
    mesh.vertices.row(v) = i * a1 + j * a2;
    add({i, j}, {i + 1, j}, {i, j + 1});
    add({i, j}, {i, j + 1}, {i - 1, j + 1});
  }
  mesh.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) mesh.faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  return mesh;
}

/// A sheet in the plane z = 0, rolled without stretching on a cylinder whose axis is parallel to y.
inline TriangleMesh rolled(TriangleMesh sheet, double radius) {
  for (auto p : sheet.vertices.rowwise()) {
    p = Eigen::RowVector3d(radius * std::sin(p(0) / radius), p(1), radius * std::cos(p(0) / radius));
  }
  return sheet;
}

/// Bending of an open patch that is flat where it is free of stress, node by node; all zero on its rim.
struct PatchBending {
  Eigen::ArrayXd energy;     ///< of the node's mean curvature, or half of that of its hinges
  Eigen::ArrayXd curvature;  ///< twice the mean curvature
  Eigen::ArrayXd area;       ///< a third of the node's faces
};

inline PatchBending patch_bending(BendingLaw law, const TriangleMesh& patch) {
  std::map<std::pair<int, int>, int> third;  // from the ends of an edge of a face to its third corner
  for (auto face : patch.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) third[{face(k), face((k + 1) % 3)}] = face((k + 2) % 3);
  }
  const Eigen::Index nv = patch.vertices.rows();
  Eigen::ArrayXd hinges = Eigen::ArrayXd::Zero(nv), edge_sum = hinges, area = hinges, inner = hinges + 1;
  const ConstColumns3 x(patch.vertices);
  for (const auto& [ends, v3] : third) {
    const auto [v1, v2] = ends;
    const auto twin = third.find({v2, v1});
    if (twin == third.end()) {
      inner(v1) = inner(v2) = 0;
      continue;
    }
    // A node meets each of its edges, and each of its faces, once as v1.
    const Vec3 e = x[v2] - x[v1], n = cross(e, x[v3] - x[v1]), m = cross(x[twin->second] - x[v1], e);
    hinges(v1) += 0.5 * hinge_energy(entry(law).hinge_prefactor, e, n, m, {0, 1});
    edge_sum(v1) += std::sqrt(dot(e, e)) * bending_angle(e, n, m, {0, 1});
    area(v1) += face_area(n) / 3;
  }
  PatchBending bending{inner * hinges, Eigen::ArrayXd::Zero(nv), inner * area};
  for (Eigen::Index v = 0; v < nv; ++v) {
    if (inner(v) == 0) continue;
    bending.curvature(v) = twice_mean_curvature(edge_sum(v), area(v));
    if (law == BendingLaw::mean_curvature)
      bending.energy(v) = mean_curvature_energy(1, bending.curvature(v), 0, area(v));
  }
  return bending;
}

/// Modulus that a sheet feels which is rolled on a cylinder, over kB: its energy over A / (2 R^2).
inline double fold_ratio(BendingLaw law, const TriangleMesh& sheet, double radius) {
  const PatchBending bending = patch_bending(law, rolled(sheet, radius));
  return 2 * radius * radius * bending.energy.sum() / bending.area.sum();
}

/// The same of a sheet of equilateral triangles whose edges are turned by an angle against the bend; radius
/// in units of the edge.
inline double fold_ratio(BendingLaw law, double radius, double turn) {
  return fold_ratio(law, hexagon(4, turn), radius);
}

/// Energy of a sphere that is bent from a flat sheet, over 8 pi kB.
inline double sphere_ratio(BendingLaw law, const TriangleMesh& ball) {
  const Membrane membrane(ball, {.bending = 1, .bending_law = law}, StressFreeAngle::flat);
  return membrane.energy(ball.vertices) / (8 * std::numbers::pi);
}

/// (largest - smallest) / mean bending energy of the resting red blood cell when it is stretched by 1.3 along
/// a direction in its plane and squeezed by 1.3 across, over the directions in steps of 5 degrees.
inline double squeeze_anisotropy(BendingLaw law, int frequency) {
  const Membrane membrane(red_blood_cell(frequency, 1.0), {.bending = 1, .bending_law = law});
  Eigen::ArrayXd energy(36);
  for (int k = 0; k < energy.size(); ++k) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(k * std::numbers::pi / 36, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d squeeze = turn * Eigen::Vector3d(1.3, 1 / 1.3, 1).asDiagonal() * turn.transpose();
    energy(k) = membrane.energy(membrane.reference().vertices * squeeze);
  }
  return (energy.maxCoeff() - energy.minCoeff()) / energy.mean();
}

}  // namespace dld::test
