/// The in-place lattice against a plain two-array one, and identities that hold to rounding.
#include "fluid/lattice.hpp"

#include <gtest/gtest.h>

#include "support/fluid_box.hpp"
#include "support/naive_fluid.hpp"

namespace dld {
namespace {

using test::BoxSize;
using test::for_fluid_nodes;
using test::NaiveFluid;
using test::RandomNumbers;
using test::unit_cell;

constexpr std::array<double, 3> uniform_force{2e-4, -5e-5, 3e-5};

struct Combination {
  CollisionModel collision;
  EquilibriumModel equilibrium;
  WallModel walls;
  HeightBoundary height;
  bool local;             ///< force and relaxation time of their own in an active range
  bool pillar_on_border;  ///< the pillar is cut by the corner of the unit cell
};

std::vector<Combination> combinations() {
  std::vector<Combination> all;
  for (auto collision : {CollisionModel::bgk, CollisionModel::trt})
    for (auto equilibrium : {EquilibriumModel::full, EquilibriumModel::stokes})
      for (auto walls : {WallModel::half_way, WallModel::interpolated, WallModel::central_linear})
        for (auto height : {HeightBoundary::walls, HeightBoundary::mirror_and_wall, HeightBoundary::periodic})
          for (bool local : {false, true})
            all.push_back({collision, equilibrium, walls, height, local, local});
  return all;
}

std::string name_of(const testing::TestParamInfo<Combination>& info) {
  const Combination& c = info.param;
  std::string name = c.collision == CollisionModel::bgk ? "Bgk" : "Trt";
  name += c.equilibrium == EquilibriumModel::full ? "Full" : "Stokes";
  name += c.walls == WallModel::half_way       ? "HalfWay"
          : c.walls == WallModel::interpolated ? "Interpolated"
                                               : "CentralLinear";
  name += c.height == HeightBoundary::walls      ? "Walls"
          : c.height == HeightBoundary::periodic ? "Periodic"
                                                 : "Mirror";
  return name + (c.local ? "Local" : "Uniform");
}

class LatticeAgainstNaive : public testing::TestWithParam<Combination> {
 protected:
  static constexpr double radius = 4.37;  // no node exactly on the surface
  BoxSize size() const { return {20, 21, 4, radius, 6, GetParam().height}; }
  FluidModel model() const {
    const Combination& c = GetParam();
    FluidModel m;
    m.collision = c.collision;
    m.equilibrium = c.equilibrium;
    m.walls = c.walls;
    m.magic_parameter = 0.21;
    m.relaxation_time = 0.83;
    m.wall_motion = {-0.003, 0.005};
    return m;
  }
  double origin_x() const { return GetParam().pillar_on_border ? -1 : -10; }
  double origin_y() const { return GetParam().pillar_on_border ? -20 : -10; }

  /// The same random flow, forces and relaxation times in both. The active range runs past ny.
  template <class Real>
  std::vector<ActiveRange> prepare(Lattice<Real>& lattice, NaiveFluid& naive) const {
    RandomNumbers random(11);
    const BoxSize s = size();
    lattice.set_uniform_force(uniform_force[0], uniform_force[1], uniform_force[2]);
    lattice.initialise([&](int x, int y, int z) {
      const std::array<double, 3> u{0.01 * random(), 0.01 * random(), 0.01 * random()};
      naive.initialise(x, y, z, u);
      return u;
    });
    for (auto& f : naive.force) f = uniform_force;
    if (!GetParam().local) return {};
    std::vector<ActiveRange> active(static_cast<std::size_t>(s.nx));
    for (int x = 0; x < s.nx; ++x) {
      if (x % 5 == 3) continue;
      const ActiveRange range{(3 + 7 * x) % s.ny, x % 5 == 4 ? s.ny : 1 + (5 * x) % s.ny};
      active[static_cast<std::size_t>(x)] = range;
      for (int k = 0; k < range.length; ++k) {
        const int y = (range.begin + k) % s.ny;
        for (int z = 0; z < s.nz; ++z) {
          const auto node = lattice.layout().node(x, y, z);
          const auto n = naive.index(x, y, z);
          naive.tau[n] = 1.5 + 0.8 * random();
          lattice.relaxation_time[node] = static_cast<Real>(naive.tau[n]);
          for (std::size_t d = 0; d < 3; ++d) {
            const double f = 1e-3 * random();
            lattice.force[d][node] = static_cast<Real>(f);
            naive.force[n][d] += f;
          }
        }
      }
    }
    return active;
  }
};

TEST_P(LatticeAgainstNaive, FlowAgreesToRounding) {
  const UnitCell cell = unit_cell(size(), origin_x(), origin_y());
  NaiveFluid naive(size(), origin_x(), origin_y(), model());
  Lattice<double> lattice(cell, model());
  const auto active = prepare(lattice, naive);
  for (int step = 1; step <= 10; ++step) {
    lattice.step(active);
    naive.step();
    double worst = 0, worst_velocity = 0;
    const auto differs = [](double& w, double a, double b) { w = std::max(w, std::abs(a - b)); };
    for_fluid_nodes(cell, [&](int x, int y, int z) {
      const auto n = naive.index(x, y, z);
      const auto range = active.empty() ? ActiveRange{} : active[static_cast<std::size_t>(x)];
      if ((y - range.begin + cell.ny) % cell.ny < range.length) {
        for (std::size_t d = 0; d < 3; ++d)
          differs(worst_velocity, lattice.velocity[d][lattice.layout().node(x, y, z)], naive.velocity[n][d]);
      }
      // After an odd step only the velocity of the active range can be read.
      if (!lattice.even()) return;
      naive.update_moments(n);
      const auto m = lattice.moments(x, y, z);
      differs(worst, m[0], naive.density[n] - 1);
      for (std::size_t d = 0; d < 3; ++d) differs(worst, m[d + 1], naive.velocity[n][d]);
    });
    EXPECT_LT(worst, 1e-14) << "step " << step;
    EXPECT_LT(worst_velocity, 1e-14) << "step " << step;
  }
}

TEST_P(LatticeAgainstNaive, ThreadsChangeNoBit) {
  const UnitCell cell = unit_cell(size(), origin_x(), origin_y());
  NaiveFluid naive(size(), origin_x(), origin_y(), model());
  Lattice<float> alone(cell, model());
  for (const int threads : {2, 3, 5, 64}) {
    Lattice<float> shared(cell, model());
    shared.set_threads(threads);
    EXPECT_EQ(shared.threads(), std::min(threads, size().nx / 4));
    for (Lattice<float>* lattice : {&alone, &shared}) {
      const auto active = prepare(*lattice, naive);
      for (int step = 0; step < 10; ++step) lattice->step(active);
    }
    EXPECT_EQ(alone.populations(), shared.populations()) << threads << " threads";
  }
}

TEST_P(LatticeAgainstNaive, SinglePrecisionAgreesToFiveDigits) {
  const UnitCell cell = unit_cell(size(), origin_x(), origin_y());
  NaiveFluid naive(size(), origin_x(), origin_y(), model());
  Lattice<float> lattice(cell, model());
  const auto active = prepare(lattice, naive);
  for (int step = 0; step < 10; ++step) {
    lattice.step(active);
    naive.step();
  }
  double worst = 0, largest = 0;
  for_fluid_nodes(cell, [&](int x, int y, int z) {
    const auto n = naive.index(x, y, z);
    naive.update_moments(n);
    const auto m = lattice.moments(x, y, z);
    for (std::size_t d = 0; d < 3; ++d) {
      worst = std::max(worst, std::abs(m[d + 1] - naive.velocity[n][d]));
      largest = std::max(largest, std::abs(naive.velocity[n][d]));
    }
  });
  EXPECT_LT(worst, 1e-5 * largest);
}

INSTANTIATE_TEST_SUITE_P(Every, LatticeAgainstNaive, testing::ValuesIn(combinations()), name_of);

/// Largest difference between two fields of (density deviation, velocity) over the fluid nodes of `a`,
/// relative to the largest speed; node (x, y, z) of `a` is compared with the node of `b` at the same physical
/// place.
double relative_difference(const Lattice<double>& a, const Lattice<double>& b) {
  double worst = 0, largest = 0;
  for_fluid_nodes(a.cell(), [&](int x, int y, int z) {
    const auto steps = [](double from, double to) { return static_cast<int>(std::lround(from - to)); };
    const NodeImage image = b.cell().wrap(x + steps(a.cell().origin_x, b.cell().origin_x),
                                          y + steps(a.cell().origin_y, b.cell().origin_y),
                                          z + steps(a.cell().origin_z, b.cell().origin_z));
    const auto ma = a.moments(x, y, z), mb = b.moments(image.x, image.y, image.z);
    for (std::size_t k = 0; k < 4; ++k) {
      const double sign = image.mirrored && k == 3 ? -1.0 : 1.0;
      worst = std::max(worst, std::abs(ma[k] - sign * mb[k]));
      if (k > 0) largest = std::max(largest, std::abs(ma[k]));
    }
  });
  return worst / largest;
}

FluidModel full_interpolated() {
  FluidModel model;
  model.equilibrium = EquilibriumModel::full;
  return model;
}

Lattice<double> driven(const UnitCell& cell, const FluidModel& model, int steps) {
  Lattice<double> lattice(cell, model);
  lattice.set_uniform_force(1e-4, 0, 0);
  for (int k = 0; k < steps; ++k) lattice.step();
  return lattice;
}

// A vector of 64 bytes at the begin of a row lies in one cache line.
TEST(Lattice, RowsBeginOnCacheLines) {
  UnitCell cell;
  cell.nx = 3, cell.ny = 21, cell.nz = 2;
  mark_solid(cell, true);
  const Lattice<float> lattice(cell, {});
  const auto line = [](const float* place) { return reinterpret_cast<std::uintptr_t>(place) % 64; };
  for (int x = 0; x < cell.nx; ++x) {
    for (int z = 0; z < cell.nz; ++z) {
      EXPECT_EQ(line(lattice.velocity[1].data() + lattice.layout().node(x, 0, z)), 0u);
      for (int i = 0; i < 19; ++i)
        EXPECT_EQ(line(lattice.populations().data() + lattice.layout().population(i, x, 0, z)), 0u);
    }
  }
}

TEST(Lattice, MovingTheOriginByAWholeVectorChangesNothing) {
  const BoxSize size{20, 21, 4, 6.0, 6, HeightBoundary::mirror_and_wall};
  const Lattice<double> centred = driven(unit_cell(size), full_interpolated(), 200);
  EXPECT_GT(centred.statistics().velocity[0], 1e-4);
  for (const auto& [x, y] : {std::pair{-3, -5}, {0, 0}, {-19, -20}, {7, 33}, {-20, -10}, {-31, 11}}) {
    const Lattice<double> moved = driven(unit_cell(size, x, y), full_interpolated(), 200);
    EXPECT_LT(relative_difference(centred, moved), 1e-12) << x << ", " << y;
  }
}

TEST(Lattice, MirroredHalfIsTheFullHeight) {
  for (auto walls : {WallModel::half_way, WallModel::interpolated, WallModel::central_linear}) {
    FluidModel model = full_interpolated();
    model.walls = walls;
    BoxSize size{20, 21, 8, 6.0, 6, HeightBoundary::walls};
    const Lattice<double> full = driven(unit_cell(size), model, 300);
    size.nz = 4;
    size.height = HeightBoundary::mirror_and_wall;
    EXPECT_LT(relative_difference(full, driven(unit_cell(size), model, 300)), 1e-12);
  }
}

TEST(Lattice, UniformForceAcceleratesExactly) {
  const BoxSize size{5, 6, 4, 0, 2, HeightBoundary::periodic};
  for (auto collision : {CollisionModel::bgk, CollisionModel::trt}) {
    for (auto equilibrium : {EquilibriumModel::full, EquilibriumModel::stokes}) {
      FluidModel model;
      model.collision = collision;
      model.equilibrium = equilibrium;
      model.relaxation_time = 0.7;
      Lattice<double> lattice(unit_cell(size), model);
      const std::array<double, 3> f{1e-4, -3e-5, 2e-5};
      lattice.set_uniform_force(f[0], f[1], f[2]);
      constexpr int steps = 100;
      for (int k = 0; k < steps; ++k) lattice.step();
      // Half of the force acts within the step: u = (t + 1/2) F / rho.
      const auto m = lattice.moments(2, 3, 1);
      for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(m[d + 1], (steps + 0.5) * f[d], 1e-15);
      EXPECT_NEAR(m[0], 0, 1e-15);
    }
  }
}

TEST(Lattice, LocalForceAndRelaxationTimeActLikeUniformOnes) {
  const BoxSize size{20, 21, 4, 6.0, 6, HeightBoundary::walls};
  const UnitCell cell = unit_cell(size);
  FluidModel model = full_interpolated();
  model.relaxation_time = 1.3;
  const Lattice<double> uniform = driven(cell, model, 100);
  model.relaxation_time = 0.9;  // overruled everywhere by the local one
  Lattice<double> local(cell, model);
  std::fill(local.relaxation_time.begin(), local.relaxation_time.end(), 1.3);
  std::fill(local.force[0].begin(), local.force[0].end(), 1e-4);
  std::vector<ActiveRange> active;
  for (int x = 0; x < size.nx; ++x) active.push_back({(4 * x) % size.ny, size.ny});
  for (int k = 0; k < 100; ++k) local.step(active);
  EXPECT_LT(relative_difference(uniform, local), 1e-13);
}

TEST(Lattice, ActiveRangeWithUniformValuesChangesNothing) {
  const BoxSize size{20, 21, 4, 6.0, 6, HeightBoundary::walls};
  const Lattice<double> plain = driven(unit_cell(size), full_interpolated(), 50);
  Lattice<double> ranged(unit_cell(size), full_interpolated());
  ranged.set_uniform_force(1e-4, 0, 0);
  std::vector<ActiveRange> active(20);
  for (int k = 0; k < 50; ++k) {
    for (int x = 0; x < size.nx; ++x) active[static_cast<std::size_t>(x)] = {(x + 5 * k) % 21, (x * k) % 22};
    ranged.step(active);
  }
  EXPECT_LT(relative_difference(plain, ranged), 1e-13);
}

TEST(Lattice, HalfWayWallsConserveMass) {
  const BoxSize size{20, 21, 4, 6.0, 6, HeightBoundary::mirror_and_wall};
  FluidModel model = full_interpolated();
  model.walls = WallModel::half_way;
  const Lattice<double> lattice = driven(unit_cell(size), model, 1000);
  EXPECT_GT(lattice.statistics().max_density_deviation, 1e-5);
  EXPECT_LT(std::abs(lattice.statistics().mean_density_deviation), 1e-12);
}

TEST(Lattice, ShiftOfDensityIsSeenByTheMomentsAlone) {
  const BoxSize size{20, 21, 4, 6.0, 6, HeightBoundary::walls};
  Lattice<double> lattice = driven(unit_cell(size), FluidModel{}, 50);
  const auto before = lattice.moments(1, 2, 3);
  lattice.shift_density(0.01);
  const auto after = lattice.moments(1, 2, 3);
  EXPECT_NEAR(after[0] - before[0], 0.01, 1e-15);
  for (std::size_t d = 1; d < 4; ++d) EXPECT_NEAR(after[d], before[d], 1e-16);
}

TEST(Lattice, StatisticsShowADivergedNode) {
  const BoxSize size{8, 8, 4, 0, 0, HeightBoundary::periodic};
  Lattice<double> lattice(unit_cell(size), FluidModel{});
  lattice.populations()[lattice.layout().population(1, 3, 3, 1)] = NAN;
  EXPECT_TRUE(std::isnan(lattice.statistics().max_speed));
}

}  // namespace
}  // namespace dld
