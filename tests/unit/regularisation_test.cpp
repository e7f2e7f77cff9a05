/// Relaxation along nodal force differences: neutral to momentum, dissipative, blind to smooth forces.
#include "membrane/regularisation.hpp"

#include <gtest/gtest.h>

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

/// Velocity for forces that vary like the position on a sphere (one wavelength around it).
Eigen::MatrixX3d velocity_of_smooth_force(int frequency) {
  const Membrane membrane(sphere(frequency, 1.0), {.shear = 1});
  Eigen::MatrixX3d v = Eigen::MatrixX3d::Zero(membrane.vertex_count(), 3);
  force_difference_velocity(membrane, membrane.reference().vertices, 1.0, v);
  return v;
}

TEST(Regularisation, KeepsMomentumAndDissipates) {
  const Membrane membrane(red_blood_cell(6, 3.9), {.shear = 1});
  const Eigen::MatrixX3d f = random_forces(membrane.vertex_count());
  Eigen::MatrixX3d v = Eigen::MatrixX3d::Zero(f.rows(), 3);
  force_difference_velocity(membrane, f, 0.3, v);
  EXPECT_LT(v.colwise().sum().norm(), 1e-13 * v.rowwise().norm().sum());
  double dissipation = 0;
  for (const Edge& edge : membrane.edges())
    dissipation += 0.05 * (f.row(edge.v1) - f.row(edge.v2)).squaredNorm();
  EXPECT_NEAR((f.array() * v.array()).sum(), dissipation, 1e-12 * dissipation);
  EXPECT_GT(dissipation, 1);
}

TEST(Regularisation, AddsToTheVelocityAndIgnoresAUniformForce) {
  const Membrane membrane(sphere(4, 1.0), {.shear = 1});
  Eigen::MatrixX3d v = Eigen::MatrixX3d::Constant(membrane.vertex_count(), 3, 2.5);
  force_difference_velocity(membrane, Eigen::MatrixX3d::Constant(v.rows(), 3, 7.0), 1.0, v);
  EXPECT_TRUE((v.array() == 2.5).all());
}

TEST(Regularisation, IsNodeForceMinusNeighbourMeanAtRegularNodes) {
  const Membrane membrane(sphere(4, 1.0), {.shear = 1});
  const Eigen::MatrixX3d f = random_forces(membrane.vertex_count());
  Eigen::MatrixX3d v = Eigen::MatrixX3d::Zero(f.rows(), 3);
  force_difference_velocity(membrane, f, 1.0, v);
  int five_valent = 0;
  for (int node = 0; node < f.rows(); ++node) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    int valence = 0;
    for (const Edge& edge : membrane.edges()) {
      if (edge.v1 != node && edge.v2 != node) continue;
      sum += f.row(edge.v1 == node ? edge.v2 : edge.v1);
      ++valence;
    }
    five_valent += valence == 5;
    const Eigen::RowVector3d expected = (valence * f.row(node) - sum) / 6;
    EXPECT_LT((v.row(node) - expected).norm(), 1e-14);
  }
  EXPECT_EQ(five_valent, 12);
}

TEST(Regularisation, SmoothForcesPassAtSecondOrder) {
  const double coarse = velocity_of_smooth_force(8).norm() / 8,
               fine = velocity_of_smooth_force(16).norm() / 16;
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2);
}

}  // namespace
}  // namespace dld
