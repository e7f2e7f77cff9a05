#pragma once
/// The device: pillars of one shape in a periodic array between two walls. Whatever depends on what a pillar
/// looks like is asked here. One unit of length throughout, that of the caller (um, or lattice units).
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "geometry/gap_line.hpp"
#include "geometry/pillar_array.hpp"

namespace dld {

/// l = sqrt(G H), the length in the capillary and the Reynolds number; 0 where pillars touch.
inline double length_scale(double gap, double depth) {
  return std::sqrt(std::max(0.0, gap) * depth);
}

class Device {
 public:
  /// Pillar (n, m) stands at (n pitch_x, m pitch_y + n row_shift); the walls are `depth` apart. The x axis
  /// lies along the rows, which climb by the angle `tilt` (rad) against the flow.
  Device(std::shared_ptr<const PillarShape> pillar, double pitch_x, double pitch_y, double row_shift,
         double depth, double tilt = 0)
      : pillars_(std::move(pillar), pitch_x, pitch_y, row_shift), depth_(depth), tilt_(tilt) {}

  const PillarArray& pillars() const { return pillars_; }
  bool empty() const { return pillars_.empty(); }
  double depth() const { return depth_; }
  double tilt() const { return tilt_; }

  /// Unit vector of the driving force. Lanes follow the x axis, so that a flow that leaves them falls behind.
  std::array<double, 2> drive() const {
    if (tilt_ == 0) return {1.0, 0.0};
    return {std::cos(tilt_), -std::sin(tilt_)};
  }

  /// G: shortest distance between a pillar and its neighbour across the lane.
  double gap() const { return pillars_.shape().gap(0, pillars_.pitch_y()); }

  /// Shortest distance between a pillar and any other one.
  double narrowest_gap() const;

  /// The smaller of the extents of a pillar along x and on the gap line; the pitch without pillars.
  double thinnest_extent() const;

  /// Radius of the largest circle about a point of the line x that touches no pillar (to a 400th of the
  /// pitch).
  double room_on_line(double x) const;

  /// Where s and the gap position of a cell are measured. Of several lines that are equally narrow (to 1e-6
  /// of the pitch) the one nearest to the pillar's centre, of a stretch without it the middle: x = 0 for a
  /// pillar that is symmetric about the y axis and widest there. Without pillars the whole pitch at x = 0.
  GapLine gap_line() const;

  /// Area of one unit cell that is not pillar.
  double open_area() const { return pillars_.pitch_x() * pillars_.pitch_y() - pillars_.shape().area(); }

  /// Where a cell starts by default: half way between two rows.
  double start_x() const { return -0.5 * pillars_.pitch_x(); }

 private:
  PillarArray pillars_;
  double depth_, tilt_;
};

}  // namespace dld
