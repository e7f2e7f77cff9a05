/// Inside/outside field of a membrane and the relaxation times that follow from it.
#include "coupling/viscosity_field.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>

#include "membrane/mesh.hpp"
#include "support/fluid_box.hpp"

namespace dld {
namespace {

using test::BoxSize;
using test::for_fluid_nodes;
using test::RandomNumbers;
using test::unit_cell;

/// A red blood cell, stretched, bent, turned and moved at random.
Eigen::MatrixX3d random_cell(const TriangleMesh& mesh, unsigned seed) {
  RandomNumbers random(seed);
  Eigen::MatrixX3d x = mesh.vertices;
  const double stretch = 1 + 0.3 * random(), bend = 0.04 * random();
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    x(i, 0) *= stretch;
    x(i, 1) /= stretch;
    x(i, 2) += bend * x(i, 0) * x(i, 0);
  }
  const Eigen::Quaterniond turn = Eigen::Quaterniond(random(), random(), random(), random()).normalized();
  x = x * turn.toRotationMatrix();
  x.rowwise() += Eigen::RowVector3d(3 + random(), -5 + random(), 8 + random());
  return x;
}

TEST(InsideMarker, AgreesWithTheWindingNumber) {
  const TriangleMesh mesh = red_blood_cell(5, 6.0);
  InsideMarker marker(mesh.faces);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Eigen::MatrixX3d x = random_cell(mesh, seed);
    const InsideField& field = marker.mark(x, -2, 22);
    int inside = 0;
    for (int i = 0; i < field.nx; ++i) {
      for (int j = 0; j < field.ny; ++j) {
        for (int k = 0; k < field.nz; k += 2) {
          const Eigen::RowVector3d point(field.x0 + i, field.y0 + j, field.z0 + k);
          const bool expected = winding_number(x, mesh.faces, point) > 0.5;
          inside += expected;
          ASSERT_EQ(field.inside[field.index(i, j, k)] != 0, expected) << seed << ": " << point;
        }
      }
    }
    EXPECT_GT(inside, 50);
  }
  EXPECT_EQ(marker.odd_columns(), 0);
}

/// Vertices on whole (x, y): every column goes through vertices and edges.
TEST(InsideMarker, ColumnsThroughVerticesAndEdges) {
  TriangleMesh mesh = icosphere(6);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    mesh.vertices.row(i) *= 6.0;
    mesh.vertices(i, 0) = std::round(mesh.vertices(i, 0));
    mesh.vertices(i, 1) = std::round(mesh.vertices(i, 1));
    mesh.vertices(i, 2) += 0.37;
  }
  InsideMarker marker(mesh.faces);
  const InsideField& field = marker.mark(mesh.vertices, -8, 18);
  EXPECT_EQ(marker.odd_columns(), 0);
  // A column on the surface counts as moved by an infinitesimal step (d, d^2).
  for (int i = 0; i < field.nx; ++i) {
    for (int j = 0; j < field.ny; ++j) {
      for (int k = 0; k < field.nz; ++k) {
        const Eigen::RowVector3d point(field.x0 + i, field.y0 + j, field.z0 + k);
        const double winding =
            winding_number(mesh.vertices, mesh.faces, point + Eigen::RowVector3d(1e-4, 1e-8, 0));
        ASSERT_EQ(field.inside[field.index(i, j, k)] != 0, winding > 0.5) << point;
      }
    }
  }
}

TEST(InsideMarker, OctahedronCountsItsInnerPoints) {
  // |x| + |y| + |z - 1/2| <= 4: columns through its vertices and edges, layers never on the surface's
  // corners.
  TriangleMesh mesh;
  mesh.vertices.resize(6, 3);
  mesh.vertices << 4, 0, 0.5, -4, 0, 0.5, 0, 4, 0.5, 0, -4, 0.5, 0, 0, 4.5, 0, 0, -3.5;
  mesh.faces.resize(8, 3);
  mesh.faces << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
  InsideMarker marker(mesh.faces);
  const InsideField& field = marker.mark(mesh.vertices, -5, 12);
  int expected = 0;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 5; ++z) expected += std::abs(x) + std::abs(y) + std::abs(z - 0.5) < 4;
  EXPECT_EQ(std::accumulate(field.inside.begin(), field.inside.end(), 0), expected);
  EXPECT_EQ(marker.odd_columns(), 0);
}

/// Root mean square of the relative error of the marked volume, over random places.
double volume_error(double radius) {
  const TriangleMesh ball = sphere(6, radius);
  double volume = 0, sum = 0;
  for (Eigen::Index f = 0; f < ball.faces.rows(); ++f) {
    const Eigen::RowVector3d a = ball.vertices.row(ball.faces(f, 0)), b = ball.vertices.row(ball.faces(f, 1)),
                             c = ball.vertices.row(ball.faces(f, 2));
    volume += a.dot(b.cross(c)) / 6;
  }
  InsideMarker marker(ball.faces);
  RandomNumbers random(2);
  constexpr int places = 20;
  for (int k = 0; k < places; ++k) {
    const Eigen::MatrixX3d x = ball.vertices.rowwise() + Eigen::RowVector3d(random(), random(), random());
    const int reach = static_cast<int>(radius) + 3;
    const InsideField& field = marker.mark(x, -reach, 2 * reach + 1);
    const double marked = std::accumulate(field.inside.begin(), field.inside.end(), 0);
    sum += (marked / volume - 1) * (marked / volume - 1);
  }
  return std::sqrt(sum / places);
}

TEST(InsideMarker, MarkedVolumeApproachesThatOfTheMesh) {
  const double coarse = volume_error(3.0), middle = volume_error(6.0), fine = volume_error(12.0);
  EXPECT_LT(coarse, 0.08);
  EXPECT_LT(middle, 0.5 * coarse);
  EXPECT_LT(fine, 0.5 * middle);
}

const BoxSize box{24, 26, 12, 0, 7, HeightBoundary::walls};

struct Times {
  double smallest = 1e300, largest = 0, excess = 0;  ///< excess: sum of tau - tau_outside
};

Times times_of(const Lattice<double>& lattice, double outside) {
  Times t;
  for_fluid_nodes(lattice.cell(), [&](int x, int y, int z) {
    const double tau = lattice.relaxation_time[lattice.layout().node(x, y, z)];
    t.smallest = std::min(t.smallest, tau);
    t.largest = std::max(t.largest, tau);
    t.excess += tau - outside;
  });
  return t;
}

TEST(ViscosityField, SmoothedFieldKeepsTheBoundsAndTheAmount) {
  const TriangleMesh mesh = red_blood_cell(5, 7.0);
  Eigen::MatrixX3d x = mesh.vertices.rowwise() + Eigen::RowVector3d(0.3, 0.2, 0.1);
  Lattice<double> sharp(unit_cell(box), FluidModel{}), smooth(unit_cell(box), FluidModel{});
  ViscosityField<double>(sharp, mesh.faces, 1.0, 3.0, false).update(x);
  ViscosityField<double>(smooth, mesh.faces, 1.0, 3.0, true).update(x);
  const Times a = times_of(sharp, 1.0), b = times_of(smooth, 1.0);
  EXPECT_EQ(a.smallest, 1.0);
  EXPECT_EQ(a.largest, 3.0);
  EXPECT_EQ(b.smallest, 1.0);
  EXPECT_GT(b.largest, 1.5);
  EXPECT_LE(b.largest, 3.0);
  EXPECT_GT(a.excess, 100);
  EXPECT_NEAR(a.excess, b.excess, 1e-9);
}

TEST(ViscosityField, HalfHeightIsTheUpperHalf) {
  const TriangleMesh mesh = red_blood_cell(5, 7.0);
  const BoxSize half{24, 26, 6, 0, 7, HeightBoundary::mirror_and_wall};
  const Eigen::MatrixX3d x = mesh.vertices.rowwise() + Eigen::RowVector3d(9.3, 8.2, 0);
  for (const bool smoothed : {false, true}) {
    Lattice<double> upper(unit_cell(half), FluidModel{}), whole(unit_cell(box), FluidModel{});
    ViscosityField<double>(upper, mesh.faces, 1.0, 3.0, smoothed).update(x);
    ViscosityField<double>(whole, mesh.faces, 1.0, 3.0, smoothed).update(x);
    for_fluid_nodes(upper.cell(), [&](int a, int b, int c) {
      ASSERT_NEAR(upper.relaxation_time[upper.layout().node(a, b, c)],
                  whole.relaxation_time[whole.layout().node(a, b, c + 6)], 1e-14);
    });
  }
}

TEST(ViscosityField, MovesWithTheCellAcrossTheBordersAndLeavesNothingBehind) {
  const TriangleMesh mesh = red_blood_cell(5, 7.0);
  const Eigen::MatrixX3d x = mesh.vertices.rowwise() + Eigen::RowVector3d(0.3, 0.2, 0.1);
  for (const bool smoothed : {false, true}) {
    Lattice<double> here(unit_cell(box), FluidModel{}), moved(unit_cell(box), FluidModel{});
    ViscosityField<double>(here, mesh.faces, 1.0, 3.0, smoothed).update(x);
    ViscosityField<double> field(moved, mesh.faces, 1.0, 3.0, smoothed);
    for (const auto& [dx, dy] : {std::pair{5, 5}, {12, 13}, {24, 7}, {-30, 40}}) {
      field.update(x.rowwise() + Eigen::RowVector3d(dx, dy, 0));
      for_fluid_nodes(here.cell(), [&, dx = dx, dy = dy](int a, int b, int c) {
        const NodeImage image = moved.cell().wrap(a + dx, b + dy, c);
        ASSERT_EQ(here.relaxation_time[here.layout().node(a, b, c)],
                  moved.relaxation_time[moved.layout().node(image.x, image.y, image.z)]);
      });
    }
  }
}

TEST(ViscosityField, EqualViscositiesLeaveTheFieldAlone) {
  const TriangleMesh mesh = red_blood_cell(5, 7.0);
  Lattice<double> lattice(unit_cell(box), FluidModel{});
  ViscosityField<double>(lattice, mesh.faces, 1.0, 1.0, false).update(mesh.vertices);
  EXPECT_EQ(times_of(lattice, 1.0).largest, 1.0);
}

}  // namespace
}  // namespace dld
