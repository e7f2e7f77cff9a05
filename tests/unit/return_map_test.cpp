#include "measure/return_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace {

using dld::Crossing;
using dld::ReturnMap;
using dld::ReturnMapOptions;
using dld::TrajectoryClass;

constexpr double kPitch = 80, kTop = 25;
constexpr dld::GapLine kGap{0, kTop, kPitch - kTop};

/// A cell on a synthetic map: position above the pillar centre of its lane -> the same, one row on. Below
/// zero the cell falls into the lane below. Feeds the crossings until the class is final.
class SyntheticCell {
 public:
  SyntheticCell(double gap_position, double row_shift, ReturnMapOptions options)
      : y_(gap_position + kTop), d_(row_shift), map_(options) {}

  TrajectoryClass run(const std::function<double(double)>& step, int rows, double noise = 0) {
    std::uniform_real_distribution<double> random(-noise, noise);
    for (int k = 0; k < rows && map_.trajectory_class() == TrajectoryClass::running; ++k, ++row_) {
      const Crossing c = dld::crossing_at(y_ + random(engine_), row_, kPitch, d_, kGap);
      map_.add(c);
      y_ += d_ + step(c.gap_position);
    }
    return map_.trajectory_class();
  }
  const ReturnMap& map() const { return map_; }

 private:
  double y_, d_;
  int row_ = 0;
  std::mt19937 engine_{7};
  ReturnMap map_;
};

ReturnMapOptions options_for(double row_shift) {
  ReturnMapOptions o;
  o.epsilon = row_shift / kPitch;
  return o;
}

TEST(Lane, PillarsFollowTheRowShift) {
  EXPECT_EQ(dld::lane_of(10, 0, kPitch, 15), 0);
  EXPECT_EQ(dld::lane_of(10, 1, kPitch, 15), -1);
  EXPECT_EQ(dld::lane_of(80 + 3 * 15 + 1, 3, kPitch, 15), 1);
  const Crossing c = dld::crossing_at(80 + 3 * 15 + 31, 3, kPitch, 15, kGap);
  EXPECT_EQ(c.lane, 1);
  EXPECT_DOUBLE_EQ(c.gap_position, 6);
}

TEST(ReturnMap, ContractionIsDisplacedAtItsFixedPoint) {
  for (const double rho : {0.02, 0.3, 0.6, 0.8, -0.4}) {
    for (const double noise : {0.0, 1e-5, 5e-5}) {
      SyntheticCell cell(15, 15, ReturnMapOptions{});
      const auto step = [&](double c) { return (rho - 1) * (c - 8); };
      EXPECT_EQ(cell.run(step, 100, noise), TrajectoryClass::displaced) << rho << " " << noise;
      EXPECT_NEAR(cell.map().crossings().back().gap_position, 8, 0.06) << rho << " " << noise;
      EXPECT_NEAR(cell.map().bracket().limit, 8, 0.01) << rho << " " << noise;
      EXPECT_EQ(cell.map().defining_crossing(), static_cast<int>(cell.map().crossings().size()) - 1);
    }
  }
}

TEST(ReturnMap, CurvedContractionIsDisplaced) {
  // A kick that dies off with the distance from the pillar against a drift of -d.
  SyntheticCell cell(20, 15, options_for(15));
  EXPECT_EQ(cell.run([](double c) { return -10 + 30 * std::exp(-c / 15); }, 100), TrajectoryClass::displaced);
  EXPECT_NEAR(cell.map().bracket().limit, 15 * std::log(3), 0.02);
}

TEST(ReturnMap, RestingFromTheStartIsDisplaced) {
  SyntheticCell cell(8, 15, options_for(15));
  EXPECT_EQ(cell.run([](double c) { return -0.7 * (c - 8); }, 100, 2e-5), TrajectoryClass::displaced);
}

TEST(ReturnMap, WanderingFixedPointIsDisplaced) {
  // The mesh turns with the cell: the fixed point moves to and fro by 0.02 lu.
  SyntheticCell cell(10, 15, options_for(15));
  EXPECT_EQ(cell.run([](double c) { return -0.6 * (c - 8); }, 100, 0.02), TrajectoryClass::displaced);
  EXPECT_NEAR(cell.map().crossings().back().gap_position, 8, 0.1);
  // The same wandering beyond twice the tolerance is no proof.
  SyntheticCell far(10, 15, options_for(15));
  EXPECT_EQ(far.run([](double c) { return -0.6 * (c - 8); }, 100, 0.5), TrajectoryClass::undecided);
}

/// Just past a saddle-node the cell creeps through a bottleneck and then falls: never displaced.
TEST(ReturnMap, CreepThroughABottleneckIsNeverDisplaced) {
  for (const double a : {0.003, 0.03, 0.3, 1.0}) {
    for (const double slowest : {2e-4, 1e-3, 3e-3, 1e-2, 0.1, 1.0}) {
      for (const double start : {29.0, 21.3, 12.0, 9.0, 8.1}) {
        SyntheticCell cell(start, 15, ReturnMapOptions{});
        // Streamlines do not cross, so the map must be monotonic: the quadratic turns linear far away.
        const auto step = [&](double c) {
          const double x = std::abs(c - 8);
          return -slowest - a * x * x / (1 + 2 * a * x);
        };
        EXPECT_EQ(cell.run(step, 100000, a < 1 ? 5e-5 : 0), TrajectoryClass::zigzag)
            << a << " " << slowest << " " << start;
      }
    }
  }
}

TEST(ReturnMap, CreepBelowTheNoiseIsNotRest) {
  SyntheticCell cell(12, 15, ReturnMapOptions{});
  const auto step = [](double c) { return -3e-5 - 0.03 * (c - 8) * (c - 8); };
  EXPECT_EQ(cell.run(step, 100000), TrajectoryClass::zigzag);
}

TEST(ReturnMap, CreepIsUndecidedAtTheRowLimit) {
  SyntheticCell cell(12, 15, options_for(15));
  EXPECT_EQ(cell.run([](double c) { return -1e-3 - 0.03 * (c - 8) * (c - 8); }, 1000),
            TrajectoryClass::undecided);
  // half a cycle (3) + ceil(80 / 15) + 2
  EXPECT_EQ(cell.map().crossings().back().row, 11);
  const dld::MapBracket b = cell.map().bracket();
  EXPECT_LT(b.step, 0);
  EXPECT_GT(b.ratio, 0.75);
  EXPECT_NEAR(b.lowest_bump, cell.map().crossings()[10].gap_position, 1e-12);
  EXPECT_TRUE(std::isnan(b.highest_zig));
}

TEST(ReturnMap, PeriodicZigzagFromAnyStart) {
  for (const double d : {5.0, 11.0, 15.0, 20.0, 22.0}) {
    for (double start = -20; start < 50; start += 3.7) {
      SyntheticCell cell(start, d, options_for(d));
      EXPECT_EQ(cell.run([&](double) { return -d; }, 1000), TrajectoryClass::zigzag) << d << " " << start;
      const auto& crossings = cell.map().crossings();
      const auto defining = static_cast<std::size_t>(cell.map().defining_crossing());
      EXPECT_FALSE(
          crossings[defining + 1].bump);  // the last crossing above the pillar that it then falls behind
      EXPECT_LE(crossings.size(), 2 * std::ceil(kPitch / d) + 2);
    }
  }
}

TEST(ReturnMap, ReturnToTheWayToAZigIsZigzagAtTheRowLimit) {
  // A slow approach, a fall to c = 48, and back: at the limit of 20 rows the second zig is still to come.
  const auto step = [](double c) { return c < 3 ? -35.0 : -0.5 - 0.2 * (c - 3); };
  ReturnMapOptions options;
  options.max_rows = 20;
  SyntheticCell cell(20, 15, options);
  EXPECT_EQ(cell.run(step, 1000), TrajectoryClass::zigzag);
  EXPECT_EQ(cell.map().zigs(), 1);
  const auto& crossings = cell.map().crossings();
  EXPECT_EQ(crossings.back().row, 20);
  EXPECT_LE(crossings.back().gap_position, crossings[1].gap_position);
  EXPECT_FALSE(crossings[static_cast<std::size_t>(cell.map().defining_crossing()) + 1].bump);
  // Before it is back, one zig is not enough.
  options.max_rows = 12;
  SyntheticCell early(20, 15, options);
  EXPECT_EQ(early.run(step, 1000), TrajectoryClass::undecided);
  EXPECT_EQ(early.map().zigs(), 1);
}

TEST(ReturnMap, OneZigAtTheStartProvesNothing) {
  // From c < 3 the cell falls; from anywhere else it is led to c = 8.
  const auto step = [](double c) { return c < 3 ? -40.0 : -0.7 * (c - 8); };
  SyntheticCell cell(1, 15, options_for(15));
  EXPECT_EQ(cell.run(step, 100), TrajectoryClass::displaced);
  EXPECT_EQ(cell.map().zigs(), 1);
  EXPECT_NEAR(cell.map().bracket().highest_zig, 1, 1e-12);
  EXPECT_GT(cell.map().defining_crossing(), 2);
}

TEST(ReturnMap, OscillationThatDoesNotDecayIsUndecided) {
  SyntheticCell cell(10, 15, options_for(15));
  EXPECT_EQ(cell.run([](double c) { return -2 * (c - 8); }, 1000), TrajectoryClass::undecided);
  EXPECT_EQ(cell.map().zigs(), 0);
}

TEST(ReturnMap, AFewBumpsProveNothing) {
  SyntheticCell cell(25, 5, options_for(5));
  EXPECT_EQ(cell.run([](double) { return -1.0; }, 6), TrajectoryClass::running);
  EXPECT_EQ(cell.map().last_row(), 8 + 16 + 2);
}

TEST(ReturnMap, RowsMustFollowEachOther) {
  ReturnMap map{ReturnMapOptions{}};
  map.add(dld::crossing_at(30, 0, kPitch, 15, kGap));
  EXPECT_THROW(map.add(dld::crossing_at(30, 2, kPitch, 15, kGap)), std::invalid_argument);
}

}  // namespace
