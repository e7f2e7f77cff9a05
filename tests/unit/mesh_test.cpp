/// Meshes: counts, closedness, exact mirror symmetry, area and volume against the continuum shape.
#include "membrane/mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "membrane/membrane.hpp"

namespace dld {
namespace {

constexpr double pi = std::numbers::pi;

struct AreaVolume {
  double area, volume;
};

AreaVolume area_and_volume(const TriangleMesh& mesh) {
  const Membrane membrane(mesh, {});
  return {membrane.reference_area(), membrane.reference_volume()};
}

/// Area and volume of the Evans-Fung shape of unit radius by quadrature over q = sin(t), where the
/// profile is smooth: z = cos(t) P(sin^2 t).
AreaVolume evans_fung_continuum() {
  const auto z = [](double t) { return std::cos(t) * evans_fung_profile(std::sin(t) * std::sin(t)); };
  constexpr int n = 4000;
  AreaVolume sum{0, 0};
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) * pi / 2 / n, dt = pi / 2 / n, h = 1e-5;
    const double slope = (z(t + h) - z(t - h)) / (2 * h);
    sum.area += 4 * pi * std::sin(t) * std::hypot(std::cos(t), slope) * dt;
    sum.volume += 4 * pi * z(t) * std::sin(t) * std::cos(t) * dt;
  }
  return sum;
}

/// Whether the image of every vertex in the plane `axis` = 0 is a vertex, bit by bit.
bool mirror_symmetric(const TriangleMesh& mesh, int axis) {
  std::set<std::array<double, 3>> points;
  for (const auto& p : mesh.vertices.rowwise()) points.insert({p(0), p(1), p(2)});
  for (auto p : points) {
    p[static_cast<std::size_t>(axis)] *= -1;
    if (!points.contains(p)) return false;
  }
  return true;
}

TEST(Mesh, CountsAndEulerCharacteristic) {
  for (int n : {1, 2, 3, 5, 10}) {
    const TriangleMesh mesh = icosphere(n);
    const auto edges = edges_of(mesh);
    EXPECT_EQ(mesh.faces.rows(), 20 * n * n);
    EXPECT_EQ(mesh.vertices.rows(), 10 * n * n + 2);
    EXPECT_EQ(static_cast<long>(edges.size()), 30 * n * n);
    EXPECT_EQ(mesh.vertices.rows() - static_cast<long>(edges.size()) + mesh.faces.rows(), 2);
  }
}

TEST(Mesh, IcosahedronIsRegular) {
  const TriangleMesh mesh = icosphere(1);
  for (const Edge& e : edges_of(mesh)) {
    const double length = (mesh.vertices.row(e.v1) - mesh.vertices.row(e.v2)).norm();
    EXPECT_NEAR(length, 1.0514622242382672, 1e-14);  // 4 / sqrt(10 + 2 sqrt(5))
  }
}

TEST(Mesh, EdgesJoinTheirTwoFaces) {
  const TriangleMesh mesh = icosphere(4);
  const auto vertices_of = [&](int f) {
    return std::set<int>{mesh.faces(f, 0), mesh.faces(f, 1), mesh.faces(f, 2)};
  };
  for (const Edge& e : edges_of(mesh)) {
    EXPECT_EQ(vertices_of(e.face), (std::set<int>{e.v1, e.v2, e.v3}));
    EXPECT_EQ(vertices_of(e.opposite_face), (std::set<int>{e.v1, e.v2, e.v4}));
    EXPECT_NE(e.v3, e.v4);
  }
}

TEST(Mesh, FacesPointOutward) {
  for (const TriangleMesh& mesh : {icosphere(3), red_blood_cell(6, 2.0)}) {
    EXPECT_GT(area_and_volume(mesh).volume, 0);
  }
  const TriangleMesh mesh = icosphere(5);
  for (long f = 0; f < mesh.faces.rows(); ++f) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.row(k) = mesh.vertices.row(mesh.faces(f, k));
    EXPECT_GT(corners.determinant(), 0);
  }
}

TEST(Mesh, OpenOrInconsistentMeshIsRefused) {
  TriangleMesh open = icosphere(2);
  open.faces.conservativeResize(open.faces.rows() - 1, 3);
  EXPECT_THROW(edges_of(open), std::invalid_argument);
  TriangleMesh flipped = icosphere(2);
  std::swap(flipped.faces(0, 0), flipped.faces(0, 1));
  EXPECT_THROW(edges_of(flipped), std::invalid_argument);
  TriangleMesh inside_out = icosphere(2);
  inside_out.faces.col(0).swap(inside_out.faces.col(1));
  EXPECT_THROW(Membrane(inside_out, {}), std::invalid_argument);
}

TEST(Mesh, MirrorSymmetryIsExact) {
  for (int n : {3, 5, 10}) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(mirror_symmetric(icosphere(n), axis)) << n << " axis " << axis;
      EXPECT_TRUE(mirror_symmetric(red_blood_cell(n, 9.75), axis)) << n << " axis " << axis;
    }
  }
}

TEST(Mesh, RedBloodCellHasThePublishedArea) {
  const auto [area, volume] = area_and_volume(red_blood_cell(10, 9.75));
  EXPECT_NEAR(area / std::pow(9.75, 2), 8.735, 5e-4);
  EXPECT_LT(volume / std::pow(9.75, 3), 1.574);
  const TriangleMesh mesh = red_blood_cell(10, 9.75);
  EXPECT_NEAR(mesh.vertices.col(0).maxCoeff(), 9.75, 1e-12);
  EXPECT_NEAR(mesh.vertices.leftCols<2>().rowwise().norm().maxCoeff(), 9.75, 1e-12);
}

TEST(Mesh, AreaAndVolumeConvergeAtSecondOrder) {
  const AreaVolume exact = evans_fung_continuum();
  EXPECT_NEAR(exact.area, 8.771, 5e-4);
  EXPECT_NEAR(exact.volume, 1.574, 5e-4);
  AreaVolume coarse{}, fine{};
  for (int n : {16, 32}) {
    const auto mesh = area_and_volume(red_blood_cell(n, 1.0));
    coarse = fine;
    fine = {exact.area - mesh.area, exact.volume - mesh.volume};
  }
  EXPECT_NEAR(std::log2(coarse.area / fine.area), 2.0, 0.1);
  EXPECT_NEAR(std::log2(coarse.volume / fine.volume), 2.0, 0.1);
  EXPECT_LT(std::abs(fine.area), 0.005);
}

TEST(Mesh, RegistryKnowsItsShapes) {
  for (const std::string& name : cell_shape_names()) {
    EXPECT_EQ(make_cell(name, 3, 2.0).faces.rows(), 180) << name;
  }
  EXPECT_TRUE(make_cell("sphere", 4, 2.0).vertices.isApprox(sphere(4, 2.0).vertices));
  EXPECT_THROW(make_cell("cube", 4, 2.0), std::invalid_argument);
  EXPECT_THROW(make_cell("sphere", 0, 2.0), std::invalid_argument);
}

}  // namespace
}  // namespace dld
