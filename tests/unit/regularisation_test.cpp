/// Relaxation along nodal force differences: neutral to momentum, dissipative, blind to smooth forces.
#include "membrane/regularisation.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <random>

namespace dld {
namespace {

Eigen::MatrixX3d random_forces(long n) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixX3d f(n, 3);
  for (double& value : f.reshaped()) value = uniform(generator);
  return f;
}

/// A membrane with the gradient of its volume at the reference shape.
struct Surface {
  Membrane membrane;
  Eigen::MatrixX3d gradient;
  explicit Surface(TriangleMesh mesh)
      : membrane(std::move(mesh), {.shear = 1}), gradient(membrane.vertex_count(), 3) {
    membrane.volume_gradient(membrane.reference().vertices, gradient);
  }
  Eigen::MatrixX3d velocity(const Eigen::MatrixX3d& f, double mobility) const {
    Eigen::MatrixX3d v = Eigen::MatrixX3d::Zero(f.rows(), 3);
    tangential_relaxation(membrane, f, gradient, mobility, v);
    return v;
  }
  Eigen::RowVector3d tangential(const Eigen::MatrixX3d& f, int node) const {
    const Eigen::RowVector3d n = gradient.row(node).normalized();
    return f.row(node) - f.row(node).dot(n) * n;
  }
};

/// Random forces that add up to zero, as elastic ones do.
Eigen::MatrixX3d balanced_forces(long n) {
  Eigen::MatrixX3d f = random_forces(n);
  f.rowwise() -= f.colwise().mean();
  return f;
}

TEST(Regularisation, KeepsMomentumAndDissipates) {
  const Surface cell(red_blood_cell(6, 3.9));
  const Eigen::MatrixX3d f = balanced_forces(cell.membrane.vertex_count()), v = cell.velocity(f, 0.3);
  EXPECT_LT(v.colwise().sum().norm(), 1e-13 * v.rowwise().norm().sum());
  double dissipation = 0;
  for (const Edge& edge : cell.membrane.edges())
    dissipation += 0.05 * (cell.tangential(f, edge.v1) - cell.tangential(f, edge.v2)).squaredNorm();
  EXPECT_NEAR((f.array() * v.array()).sum(), dissipation, 1e-12 * dissipation);
  EXPECT_GT(dissipation, 1);
}

TEST(Regularisation, SlidesNodesWithinTheSurfaceAndKeepsTheVolume) {
  const Surface cell(red_blood_cell(6, 3.9));
  const Eigen::MatrixX3d v = cell.velocity(balanced_forces(cell.membrane.vertex_count()), 0.3);
  // What all nodes share is the mean that was taken off.
  const Eigen::VectorXd normal_part = (v.array() * cell.gradient.array()).rowwise().sum();
  const Eigen::MatrixX3d& g = cell.gradient;
  const Eigen::RowVector3d mean = g.colPivHouseholderQr().solve(normal_part).transpose();
  EXPECT_LT((normal_part - g * mean.transpose()).norm(), 1e-13 * v.norm());
  EXPECT_NEAR(normal_part.sum(), 0.0, 1e-13 * v.norm());
}

TEST(Regularisation, AddsToTheVelocityAndIgnoresPressure) {
  const Surface cell(sphere(4, 1.0));
  Eigen::MatrixX3d v = Eigen::MatrixX3d::Constant(cell.membrane.vertex_count(), 3, 2.5);
  tangential_relaxation(cell.membrane, 7.0 * cell.gradient, cell.gradient, 1.0, v);
  EXPECT_LT((v.array() - 2.5).abs().maxCoeff(), 1e-14);
}

TEST(Regularisation, IsNodeForceMinusNeighbourMeanAtRegularNodes) {
  const Surface cell(sphere(4, 1.0));
  const Eigen::MatrixX3d f = balanced_forces(cell.membrane.vertex_count()), v = cell.velocity(f, 1.0);
  Eigen::MatrixX3d expected(f.rows(), 3);
  int five_valent = 0;
  for (int node = 0; node < f.rows(); ++node) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    int valence = 0;
    for (const Edge& edge : cell.membrane.edges()) {
      if (edge.v1 != node && edge.v2 != node) continue;
      sum += cell.tangential(f, edge.v1 == node ? edge.v2 : edge.v1);
      ++valence;
    }
    five_valent += valence == 5;
    const Eigen::RowVector3d n = cell.gradient.row(node).normalized();
    const Eigen::RowVector3d difference = (valence * cell.tangential(f, node) - sum) / 6;
    expected.row(node) = difference - difference.dot(n) * n;
  }
  expected.rowwise() -= expected.colwise().mean();
  EXPECT_LT((v - expected).norm(), 1e-13);
  EXPECT_EQ(five_valent, 12);
}

TEST(Regularisation, SmoothForcesPassAtSecondOrder) {
  // A force that turns around the axis of a sphere is tangential and smooth.
  const auto size = [](int frequency) {
    const Surface cell(sphere(frequency, 1.0));
    const Eigen::MatrixX3d& x = cell.membrane.reference().vertices;
    Eigen::MatrixX3d f(x.rows(), 3);
    f << -x.col(1), x.col(0), Eigen::VectorXd::Zero(x.rows());
    return cell.velocity(f, 1.0).norm() / frequency;
  };
  const double coarse = size(8), middle = size(16), fine = size(32);
  EXPECT_NEAR(std::log2(coarse / middle), 2.0, 0.2);
  EXPECT_NEAR(std::log2(middle / fine), 2.0, 0.2);
  EXPECT_LT(fine, 0.01);
}

}  // namespace
}  // namespace dld
