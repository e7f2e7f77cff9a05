#include "measure/plane_field.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace dld {
namespace {

/// Cubic Lagrange weights of the nodes -1, 0, 1, 2 at 0 <= s < 1.
Eigen::Array4d lagrange_weights(double s) {
  return {-s * (s - 1) * (s - 2) / 6, (s + 1) * (s - 1) * (s - 2) / 2, -(s + 1) * s * (s - 2) / 2,
          (s + 1) * s * (s - 1) / 6};
}

constexpr double kFitRadius = 3.0;  // lu: half a disc of this radius still holds about 14 nodes

}  // namespace

PlaneField::PlaneField(Eigen::ArrayXXd u, Eigen::ArrayXXd v, SolidFlags solid, double x0, double y0,
                       int row_shift, DistanceFunction distance)
    : u_(std::move(u)),
      v_(std::move(v)),
      solid_(std::move(solid)),
      x0_(x0),
      y0_(y0),
      row_shift_(row_shift),
      distance_(std::move(distance)) {
  if (u_.size() == 0 || v_.rows() != u_.rows() || v_.cols() != u_.cols() || solid_.rows() != u_.rows() ||
      solid_.cols() != u_.cols()) {
    throw std::invalid_argument("PlaneField: u, v and solid must have the same, non-zero shape");
  }
  if (!distance_) return;
  node_distance_.resize(u_.rows(), u_.cols());
  for (int j = 0; j < ny(); ++j) {
    for (int i = 0; i < nx(); ++i) node_distance_(i, j) = distance_(i + x0_, j + y0_);
  }
}

PlaneField::Node PlaneField::wrap(int i, int j) const {
  const int n = static_cast<int>(std::floor(static_cast<double>(i) / nx()));
  j -= n * row_shift_;
  const int m = static_cast<int>(std::floor(static_cast<double>(j) / ny()));
  return {i - n * nx(), j - m * ny()};
}

bool PlaneField::stencil_is_fluid(int i, int j) const {
  for (int b = -1; b <= 2; ++b) {
    for (int a = -1; a <= 2; ++a) {
      const Node k = wrap(i + a, j + b);
      if (solid_(k.i, k.j) != 0) return false;
    }
  }
  return true;
}

Eigen::Vector2d PlaneField::bicubic(int i, int j, double s, double t) const {
  const Eigen::Array4d ws = lagrange_weights(s), wt = lagrange_weights(t);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) {
      const Node k = wrap(i + a - 1, j + b - 1);
      sum += ws(a) * wt(b) * Eigen::Vector2d(u_(k.i, k.j), v_(k.i, k.j));
    }
  }
  return sum;
}

Eigen::Vector2d PlaneField::velocity_bilinear(double x, double y) const {
  const double fx = std::floor(x - x0_), fy = std::floor(y - y0_);
  const double s = x - x0_ - fx, t = y - y0_ - fy;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int b = 0; b < 2; ++b) {
    for (int a = 0; a < 2; ++a) {
      const Node k = wrap(static_cast<int>(fx) + a, static_cast<int>(fy) + b);
      if (solid_(k.i, k.j) != 0) continue;
      sum += (a ? s : 1 - s) * (b ? t : 1 - t) * Eigen::Vector2d(u_(k.i, k.j), v_(k.i, k.j));
    }
  }
  return sum;
}

Eigen::Vector2d PlaneField::wall_fit(double x, double y) const {
  const double phi = distance_(x, y);
  if (phi <= 0) return Eigen::Vector2d::Zero();
  // Residuals are taken in u and not in u / phi, so that a node a hair off the wall carries no weight.
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 2> rhs = Eigen::Matrix<double, 6, 2>::Zero();
  const int ic = static_cast<int>(std::floor(x - x0_)), jc = static_cast<int>(std::floor(y - y0_));
  for (int j = jc - 2; j <= jc + 3; ++j) {
    for (int i = ic - 2; i <= ic + 3; ++i) {
      const double p = i + x0_ - x, q = j + y0_ - y;
      const double reach = 1 - (p * p + q * q) / (kFitRadius * kFitRadius);
      const Node k = wrap(i, j);
      if (reach <= 0 || solid_(k.i, k.j) != 0) continue;
      const double weight = reach * reach * reach * reach;
      Eigen::Vector<double, 6> basis;
      basis << 1, p, q, p * p, p * q, q * q;
      basis *= node_distance_(k.i, k.j);
      normal += weight * basis * basis.transpose();
      rhs += weight * basis * Eigen::RowVector2d(u_(k.i, k.j), v_(k.i, k.j));
    }
  }
  if (normal(0, 0) <= 0) return Eigen::Vector2d::Zero();
  // A trace of ridge keeps the fit defined where a narrow slot leaves fewer than six nodes.
  normal.diagonal().array() += 1e-10 * normal(0, 0);
  return phi * normal.ldlt().solve(rhs).row(0).transpose();
}

Eigen::Vector2d PlaneField::velocity(double x, double y) const {
  const double fx = std::floor(x - x0_), fy = std::floor(y - y0_);
  const int i = static_cast<int>(fx), j = static_cast<int>(fy);
  if (stencil_is_fluid(i, j)) return bicubic(i, j, x - x0_ - fx, y - y0_ - fy);
  return distance_ ? wall_fit(x, y) : velocity_bilinear(x, y);
}

PlaneFlow PlaneField::flow(const GapLine& gap, double tilt) const {
  return {[this](double x, double y) { return velocity(x, y); },
          distance_,
          static_cast<double>(nx()),
          static_cast<double>(ny()),
          static_cast<double>(row_shift_),
          gap,
          tilt};
}

}  // namespace dld
