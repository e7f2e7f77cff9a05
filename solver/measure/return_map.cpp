#include "measure/return_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace dld {
namespace {

// A step has to be this many times the noise for its ratio to the next one to be known within a few per cent.
constexpr double kClearOfNoise = 30;
// Steps over which a map must have stayed in place before it counts as resting.
constexpr int kRestingSteps = 4;

}  // namespace

int lane_of(double y, int row, double pitch_y, double row_shift, double pillar_middle) {
  return static_cast<int>(std::floor((y - row * row_shift - pillar_middle) / pitch_y));
}

Crossing crossing_at(double y, int row, double pitch_y, double row_shift, const GapLine& gap) {
  Crossing c;
  c.row = row;
  c.lane = lane_of(y, row, pitch_y, row_shift, gap.pillar_middle(pitch_y));
  c.gap_position = y - c.lane * pitch_y - row * row_shift - gap.lower;
  return c;
}

std::string to_string(TrajectoryClass c) {
  switch (c) {
    case TrajectoryClass::displaced:
      return "displaced";
    case TrajectoryClass::zigzag:
      return "zigzag";
    case TrajectoryClass::undecided:
      return "undecided";
    case TrajectoryClass::running:
      break;
  }
  return "running";
}

TrajectoryClass ReturnMap::add(Crossing crossing) {
  if (!crossings_.empty()) {
    if (crossing.row != crossings_.back().row + 1) {
      throw std::invalid_argument("ReturnMap: crossings must come row by row");
    }
    crossing.bump = crossing.lane >= crossings_.back().lane;
  } else {
    crossing.bump = true;  // the way to the first crossing belongs to the start
  }
  if (!crossing.bump) zig_indices_.push_back(static_cast<int>(crossings_.size()));
  crossings_.push_back(crossing);
  class_ = classify();
  return class_;
}

std::vector<double> ReturnMap::last_steps(int count) const {
  const std::size_t n = crossings_.size(), needed = static_cast<std::size_t>(count) + 1;
  if (n < needed) return {};
  std::vector<double> steps;
  for (std::size_t k = n - needed + 1; k < n; ++k) {
    if (crossings_[k].lane != crossings_[k - 1].lane) return {};
    steps.push_back(crossings_[k].gap_position - crossings_[k - 1].gap_position);
  }
  return steps;
}

ReturnMap::FixedPoint ReturnMap::fixed_point() const {
  const std::vector<double> d = last_steps(3);
  if (d.empty() || std::min(std::abs(d[0]), std::abs(d[1])) < kClearOfNoise * options_.noise) return {};
  const double r1 = d[1] / d[0], r2 = d[2] / d[1];
  const double uncertainty = 2 * options_.noise / std::abs(d[1]);  // of either ratio, at worst
  if (std::max(std::abs(r1), std::abs(r2)) + uncertainty >= options_.largest_ratio) return {};
  // Step as a function of position, g(c) = f(c) - c, through its last three values by Newton's divided
  // differences: g = q t^2 + b t + d[2] with t = c - c_n-1. Its root is the fixed point of the map f, and
  // sqrt(b^2 - 4 q d[2]) = 1 - f' there: a saddle-node has no root, or one with f' near 1.
  const double q = (r2 - r1) / (d[0] + d[1]);
  const double b = r2 - 1 + q * d[1];
  const double discriminant = b * b - 4 * q * d[2];
  const double slack = 1 - options_.largest_ratio;
  if (b >= 0 || discriminant < slack * slack) return {};
  const double quadratic_rest = 2 * d[2] / (-b + std::sqrt(discriminant)) - d[2];
  const double geometric_rest = d[2] * r2 / (1 - r2);
  const bool proven = std::abs(r1 - r2) < options_.ratio_agreement &&
                      std::max(std::abs(quadratic_rest), std::abs(geometric_rest)) < options_.tolerance;
  return {proven, crossings_.back().gap_position + geometric_rest};
}

double ReturnMap::last_measurable_ratio() const {
  for (std::size_t k = crossings_.size(); k-- > 2;) {
    const Crossing &a = crossings_[k - 2], &b = crossings_[k - 1], &c = crossings_[k];
    if (a.lane != b.lane || b.lane != c.lane) return 0;
    const double earlier = b.gap_position - a.gap_position, later = c.gap_position - b.gap_position;
    if (std::abs(earlier) > kClearOfNoise * options_.noise) return later / earlier;
  }
  return 0;
}

bool ReturnMap::rests() const {
  const std::vector<double> d = last_steps(kRestingSteps);
  if (d.empty()) return false;
  double low = crossings_.back().gap_position, high = low, position = low;
  for (std::size_t k = d.size(); k-- > 0;) {
    position -= d[k];
    low = std::min(low, position);
    high = std::max(high, position);
  }
  if (high - low > 2 * options_.tolerance) return false;
  // A creep through the bottleneck of a saddle-node keeps its direction; a state at rest goes both ways.
  const bool up = std::any_of(d.begin(), d.end(), [](double s) { return s > 0; });
  const bool down = std::any_of(d.begin(), d.end(), [](double s) { return s < 0; });
  if (up && down) return true;
  const bool still = std::all_of(d.begin(), d.end(), [&](double s) { return std::abs(s) < options_.noise; });
  return still && std::abs(last_measurable_ratio()) < options_.largest_ratio;
}

int ReturnMap::last_row() const {
  if (crossings_.empty()) return std::numeric_limits<int>::max();
  const int first = crossings_.front().row;
  if (options_.max_rows > 0) return first + options_.max_rows;
  if (options_.epsilon <= 0) return std::numeric_limits<int>::max();
  const int cycle = static_cast<int>(std::ceil(1 / options_.epsilon - 1e-9));
  const int transient_end = zig_indices_.empty()
                                ? first + static_cast<int>(std::ceil(0.5 / options_.epsilon - 1e-9))
                                : crossings_[static_cast<std::size_t>(zig_indices_.front())].row;
  return transient_end + cycle + 2;
}

bool ReturnMap::returns_to_zig() const {
  if (zigs() != 1 || !crossings_.back().bump) return false;
  const double now = crossings_.back().gap_position;
  const auto zig = crossings_.begin() + zig_indices_.front();
  // The first crossing is left out: the cell still has the shape of its start.
  return std::any_of(crossings_.begin() + 1, zig,
                     [&](const Crossing& earlier) { return now <= earlier.gap_position; });
}

TrajectoryClass ReturnMap::classify() const {
  if (zigs() >= 2) return TrajectoryClass::zigzag;
  if (fixed_point().proven || rests()) return TrajectoryClass::displaced;
  if (crossings_.back().row < last_row()) return TrajectoryClass::running;
  return returns_to_zig() ? TrajectoryClass::zigzag : TrajectoryClass::undecided;
}

MapBracket ReturnMap::bracket() const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  MapBracket result;
  result.lowest_bump = result.highest_zig = kNone;
  result.zigs = zigs();
  for (std::size_t k = 1; k < crossings_.size(); ++k) {
    const double c = crossings_[k - 1].gap_position;  // fmin and fmax pass over the NaN
    if (crossings_[k].bump) {
      result.lowest_bump = std::fmin(result.lowest_bump, c);
    } else {
      result.highest_zig = std::fmax(result.highest_zig, c);
    }
  }
  if (crossings_.empty()) return result;
  if (const auto last = last_steps(1); !last.empty()) result.step = last[0];
  if (const double ratio = last_measurable_ratio(); ratio != 0) result.ratio = ratio;
  result.limit = crossings_.back().gap_position;
  if (const FixedPoint f = fixed_point(); f.limit != 0) result.limit = f.limit;
  return result;
}

int ReturnMap::defining_crossing() const {
  if (class_ != TrajectoryClass::zigzag) return static_cast<int>(crossings_.size()) - 1;
  if (zigs() == 1) return zig_indices_[0] - 1;
  const auto first = crossings_.begin() + zig_indices_[0], second = crossings_.begin() + zig_indices_[1];
  const auto lowest = std::min_element(
      first, second, [](const Crossing& a, const Crossing& b) { return a.gap_position < b.gap_position; });
  return static_cast<int>(lowest - crossings_.begin());
}

}  // namespace dld
