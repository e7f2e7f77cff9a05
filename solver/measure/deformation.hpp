#pragma once
/// Semi-axes of the ellipsoid with the same volume and second moments of volume as a closed mesh.
#include <Eigen/Dense>  // eigenvalues, cross product

namespace dld {

/// Semi-axes in ascending order. For an ellipsoid of semi-axes a_k the principal second moments about the
/// centre are V a_k^2 / 5. vertices (nv, 3), faces (nf, 3) outward.
inline Eigen::Vector3d equivalent_semi_axes(const Eigen::MatrixX3d& vertices, const Eigen::MatrixX3i& faces) {
  double volume = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    // Tetrahedron of the face and the origin: exact moments of a simplex.
    const Eigen::Vector3d a = vertices.row(faces(f, 0)), b = vertices.row(faces(f, 1)),
                          c = vertices.row(faces(f, 2));
    const double v = a.dot(b.cross(c)) / 6.0;
    const Eigen::Vector3d sum = a + b + c;
    volume += v;
    first += v / 4.0 * sum;
    second += v / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  const Eigen::Vector3d centre = first / volume;
  const Eigen::Matrix3d central = second / volume - centre * centre.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(central);
  return (5.0 * solver.eigenvalues()).cwiseSqrt();
}

/// Taylor's deformation parameter (L - B) / (L + B) of the largest and the smallest semi-axis.
inline double taylor_deformation(const Eigen::Vector3d& semi_axes) {
  return (semi_axes.maxCoeff() - semi_axes.minCoeff()) / (semi_axes.maxCoeff() + semi_axes.minCoeff());
}

}  // namespace dld
