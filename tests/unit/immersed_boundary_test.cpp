/// Spreading and interpolation: what is conserved, what is exact, what is adjoint.
#include "coupling/immersed_boundary.hpp"

#include <gtest/gtest.h>

#include "membrane/mesh.hpp"
#include "support/fluid_box.hpp"

namespace dld {
namespace {

using test::BoxSize;
using test::for_fluid_nodes;
using test::RandomNumbers;
using test::unit_cell;

constexpr std::array kernels{Kernel::phi2, Kernel::phi3, Kernel::phi4};

Eigen::MatrixX3d random_matrix(int n, unsigned seed) {
  RandomNumbers random(seed);
  Eigen::MatrixX3d m(n, 3);
  for (double& value : m.reshaped()) value = random();
  return m;
}

/// Points scattered by `size` around a centre.
Eigen::MatrixX3d points_around(const Eigen::RowVector3d& centre, const Eigen::RowVector3d& size, int n = 60) {
  Eigen::MatrixX3d x = random_matrix(n, 5);
  for (int i = 0; i < n; ++i) x.row(i) = x.row(i).cwiseProduct(size) + centre;
  return x;
}

std::vector<std::uint8_t> near_solid(const Eigen::MatrixX3d& x, bool near) {
  return std::vector<std::uint8_t>(static_cast<std::size_t>(x.rows()), near ? 1 : 0);
}

Eigen::RowVector3d total_force(const Lattice<double>& lattice) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for_fluid_nodes(lattice.cell(), [&](int x, int y, int z) {
    for (int d = 0; d < 3; ++d) {
      sum(d) += lattice.force[static_cast<std::size_t>(d)][lattice.layout().node(x, y, z)];
    }
  });
  return sum;
}

const BoxSize open_box{20, 22, 16, 0, 6, HeightBoundary::walls};
const Eigen::RowVector3d corner(9.6, 11.2,
                                0.3);  ///< near the corner (nx, ny) of the cell, origin in its middle
const Eigen::RowVector3d spread_size(4, 4, 4);

/// Lattice, boundary and stencils for some points.
struct Coupled {
  Coupled(const BoxSize& size, Kernel kernel, const Eigen::MatrixX3d& x, bool near = false)
      : lattice(unit_cell(size), FluidModel{}), boundary(lattice, kernel, coupled_nodes(x, false)) {
    boundary.locate(x, near_solid(x, near));
  }
  Lattice<double> lattice;
  ImmersedBoundary<double> boundary;
};

TEST(ImmersedBoundary, TotalForceIsKeptAcrossTheBorders) {
  const Eigen::MatrixX3d x = points_around(corner, spread_size), f = random_matrix(60, 6);
  for (const Kernel kernel : kernels) {
    Coupled s(open_box, kernel, x);
    s.boundary.spread(f);
    EXPECT_LT((total_force(s.lattice) - f.colwise().sum()).norm(), 1e-12);
    s.boundary.clear_force();
    for (const auto& component : s.lattice.force)
      for (const double value : component) ASSERT_EQ(value, 0.0);
  }
}

/// sum_i f_i . F_i = sum_x |F(x)|^2 for the spread load F and its value F_i at the nodes; and the padding
/// behind the rows is left as it was, so that the next load is not changed.
TEST(ImmersedBoundary, TheLoadAtTheNodesIsTheLoadOfTheFluid) {
  const Eigen::MatrixX3d x = points_around(corner, spread_size), f = random_matrix(60, 6);
  Eigen::MatrixX3d load(60, 3), again(60, 3);
  for (const Kernel kernel : kernels) {
    Coupled s(open_box, kernel, x);
    s.boundary.spread(f);
    s.boundary.interpolate_force(load);
    double squares = 0.0;
    for_fluid_nodes(s.lattice.cell(), [&](int nx, int ny, int nz) {
      for (const auto& component : s.lattice.force) {
        squares += std::pow(component[s.lattice.layout().node(nx, ny, nz)], 2);
      }
    });
    EXPECT_NEAR(f.cwiseProduct(load).sum(), squares, 1e-12 * squares);
    s.boundary.clear_force();
    s.boundary.spread(f);
    s.boundary.interpolate_force(again);
    EXPECT_EQ((again - load).cwiseAbs().maxCoeff(), 0.0);
  }
}

TEST(ImmersedBoundary, TotalForceIsKeptNextToAPillarAndAWall) {
  const BoxSize size{20, 22, 8, 6.0, 6, HeightBoundary::walls};
  // Around the pillar, some of them within it; and up to the top wall.
  const Eigen::MatrixX3d x = points_around({5.2, 4.3, 1.0}, {3.5, 3.5, 2.9}), f = random_matrix(60, 6);
  for (const Kernel kernel : kernels) {
    Coupled s(size, kernel, x, true);
    s.boundary.spread(f);
    // Nodes without any fluid in their stencil cannot give their force to anything.
    Eigen::RowVector3d expected = Eigen::RowVector3d::Zero();
    int lost = 0;
    for (int i = 0; i < x.rows(); ++i) {
      Coupled single(size, kernel, x.row(i), true);
      single.boundary.spread(f.row(i));
      const Eigen::RowVector3d total = total_force(single.lattice);
      lost += total.norm() == 0.0;
      if (total.norm() > 0) expected += f.row(i);
    }
    EXPECT_LT((total_force(s.lattice) - expected).norm(), 1e-12);
    EXPECT_LT(lost, 20);
    for (int a = 0; a < size.nx; ++a)
      for (int b = 0; b < size.ny; ++b)
        if (s.lattice.cell().is_solid(a, b, 4)) {
          ASSERT_EQ(s.lattice.force[0][s.lattice.layout().node(a, b, 4)], 0.0);
        }
  }
}

/// Velocity a + B r on all nodes, as if the box were not periodic.
void set_linear_velocity(Lattice<double>& lattice, const Eigen::Vector3d& a, const Eigen::Matrix3d& b) {
  const UnitCell& cell = lattice.cell();
  for_fluid_nodes(cell, [&](int x, int y, int z) {
    const Eigen::Vector3d u =
        a + b * Eigen::Vector3d(x + cell.origin_x, y + cell.origin_y, z + cell.origin_z);
    for (int d = 0; d < 3; ++d)
      lattice.velocity[static_cast<std::size_t>(d)][lattice.layout().node(x, y, z)] = u(d);
  });
}

TEST(ImmersedBoundary, LinearVelocityIsInterpolatedExactly) {
  const Eigen::MatrixX3d x = points_around({0.2, -0.4, 0.1}, spread_size);
  const Eigen::Vector3d a(0.1, -0.2, 0.3);
  const Eigen::Matrix3d b{{0.01, -0.02, 0.03}, {0.04, 0.02, -0.05}, {0.01, 0.06, -0.03}};
  for (const Kernel kernel : kernels) {
    Coupled s(open_box, kernel, x);
    set_linear_velocity(s.lattice, a, b);
    Eigen::MatrixX3d v(x.rows(), 3);
    s.boundary.interpolate(v);
    const Eigen::MatrixX3d expected = (x * b.transpose()).rowwise() + a.transpose();
    EXPECT_LT((v - expected).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(ImmersedBoundary, InterpolationIsTheAdjointOfSpreading) {
  const Eigen::MatrixX3d x = points_around(corner, spread_size), f = random_matrix(60, 6);
  for (const Kernel kernel : kernels) {
    Coupled s(open_box, kernel, x);
    s.boundary.spread(f);
    RandomNumbers random(9);
    double on_lattice = 0;
    for_fluid_nodes(s.lattice.cell(), [&](int a, int b, int c) {
      const auto node = s.lattice.layout().node(a, b, c);
      for (std::size_t d = 0; d < 3; ++d) {
        s.lattice.velocity[d][node] = random();
        on_lattice += s.lattice.velocity[d][node] * s.lattice.force[d][node];
      }
    });
    Eigen::MatrixX3d v(x.rows(), 3);
    s.boundary.interpolate(v);
    EXPECT_NEAR(v.cwiseProduct(f).sum(), on_lattice, 1e-12);
    EXPECT_GT(std::abs(on_lattice), 0.01);
  }
}

TEST(ImmersedBoundary, WholeVectorsMoveTheForceWithThePoints) {
  const Eigen::MatrixX3d x = points_around({0.2, 0.4, 0.3}, spread_size), f = random_matrix(60, 6);
  for (const Kernel kernel : kernels) {
    Coupled here(open_box, kernel, x);
    here.boundary.spread(f);
    for (const auto& [dx, dy] : {std::pair{9, 11}, {-10, 3}, {20, 6}, {37, -29}}) {
      Eigen::MatrixX3d moved = x;
      moved.rowwise() += Eigen::RowVector3d(dx, dy, 0);
      Coupled there(open_box, kernel, moved);
      there.boundary.spread(f);
      for_fluid_nodes(here.lattice.cell(), [&, dx = dx, dy = dy](int a, int b, int c) {
        const NodeImage image = there.lattice.cell().wrap(a + dx, b + dy, c);
        for (std::size_t d = 0; d < 3; ++d) {
          ASSERT_NEAR(here.lattice.force[d][here.lattice.layout().node(a, b, c)],
                      there.lattice.force[d][there.lattice.layout().node(image.x, image.y, image.z)], 1e-13);
        }
      });
    }
  }
}

TEST(ImmersedBoundary, ActiveRangeHoldsEveryNodeWithAForce) {
  const Eigen::MatrixX3d x = points_around(corner, {3, 3, 3});
  Coupled s(open_box, Kernel::phi4, x);
  s.boundary.spread(random_matrix(60, 6));
  for_fluid_nodes(s.lattice.cell(), [&](int a, int b, int c) {
    if (s.lattice.force[0][s.lattice.layout().node(a, b, c)] == 0.0) return;
    const ActiveRange range = s.boundary.active()[static_cast<std::size_t>(a)];
    EXPECT_LT((b - range.begin + open_box.ny) % open_box.ny, range.length);
  });
}

/// A flat, mirror-symmetric cell at half and at full height.
class HalfHeight : public testing::TestWithParam<Kernel> {
 protected:
  BoxSize half{20, 22, 6, 0, 6, HeightBoundary::mirror_and_wall};
  BoxSize full{20, 22, 12, 0, 6, HeightBoundary::walls};
  TriangleMesh mesh = red_blood_cell(4, 5.0);
  Eigen::MatrixX3d x = mesh.vertices.rowwise() + Eigen::RowVector3d(8.3, 9.7, 0);
  /// Mirror-symmetric forces.
  Eigen::MatrixX3d symmetric_forces() const {
    Eigen::MatrixX3d f = random_matrix(static_cast<int>(x.rows()), 6);
    for (const CoupledNode& node : coupled_nodes(mesh.vertices, true)) {
      if (node.mirror_vertex == node.vertex)
        f(node.vertex, 2) = 0;
      else
        f.row(node.mirror_vertex) = f.row(node.vertex).cwiseProduct(Eigen::RowVector3d(1, 1, -1));
    }
    return f;
  }
};

TEST_P(HalfHeight, ForceAndVelocityAreThoseOfTheFullHeight) {
  const Eigen::MatrixX3d f = symmetric_forces();
  Lattice<double> upper(unit_cell(half), FluidModel{}), whole(unit_cell(full), FluidModel{});
  ImmersedBoundary<double> upper_boundary(upper, GetParam(), coupled_nodes(mesh.vertices, true));
  ImmersedBoundary<double> whole_boundary(whole, GetParam(), coupled_nodes(mesh.vertices, false));
  upper_boundary.locate(x, near_solid(x, false));
  whole_boundary.locate(x, near_solid(x, false));
  upper_boundary.spread(f);
  whole_boundary.spread(f);
  const Eigen::RowVector3d twice = 2 * total_force(upper), all = f.colwise().sum();
  EXPECT_NEAR(twice(0), all(0), 1e-12);
  EXPECT_NEAR(twice(1), all(1), 1e-12);
  RandomNumbers random(4);
  for_fluid_nodes(upper.cell(), [&](int a, int b, int c) {
    const auto node = upper.layout().node(a, b, c), above = whole.layout().node(a, b, 6 + c),
               below = whole.layout().node(a, b, 5 - c);
    for (std::size_t d = 0; d < 3; ++d) {
      ASSERT_NEAR(upper.force[d][node], whole.force[d][above], 1e-13);
      const double u = random();
      upper.velocity[d][node] = whole.velocity[d][above] = u;
      whole.velocity[d][below] = d == 2 ? -u : u;
    }
  });
  Eigen::MatrixX3d v_upper(x.rows(), 3), v_whole(x.rows(), 3);
  upper_boundary.interpolate(v_upper);
  whole_boundary.interpolate(v_whole);
  EXPECT_LT((v_upper - v_whole).cwiseAbs().maxCoeff(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Kernels, HalfHeight, testing::ValuesIn(kernels));

TEST(CoupledNodes, PairsEveryNodeWithItsMirrorImage) {
  const TriangleMesh mesh = red_blood_cell(6, 3.9);
  std::vector<int> seen(static_cast<std::size_t>(mesh.vertices.rows()), 0);
  for (const CoupledNode& node : coupled_nodes(mesh.vertices, true)) {
    ++seen[static_cast<std::size_t>(node.vertex)];
    if (node.mirror_vertex == node.vertex) {
      EXPECT_NEAR(mesh.vertices(node.vertex, 2), 0, 1e-6);
      continue;
    }
    ++seen[static_cast<std::size_t>(node.mirror_vertex)];
    EXPECT_NEAR((mesh.vertices.row(node.vertex) - mesh.vertices.row(node.mirror_vertex)).head<2>().norm(), 0,
                1e-12);
    EXPECT_NEAR(mesh.vertices(node.vertex, 2), -mesh.vertices(node.mirror_vertex, 2), 1e-12);
  }
  for (const int times : seen) EXPECT_EQ(times, 1);
  Eigen::MatrixX3d lopsided = mesh.vertices;
  lopsided(7, 0) += 0.01;
  EXPECT_THROW(coupled_nodes(lopsided, true), std::invalid_argument);
}

}  // namespace
}  // namespace dld
