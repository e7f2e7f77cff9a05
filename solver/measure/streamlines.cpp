#include "measure/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dld {
namespace {

using Eigen::Vector2d;

/// Unit vector of the velocity, zero where the fluid rests.
Vector2d unit_direction(const PlaneFlow& flow, const Vector2d& r, int direction) {
  const Vector2d u = flow.velocity(r.x(), r.y());
  const double speed = u.norm();
  return speed > 0 ? Vector2d(direction * u / speed) : Vector2d(Vector2d::Zero());
}

/// One classical Runge-Kutta step of dr/dl = u / |u|.
Vector2d runge_kutta_step(const PlaneFlow& flow, const Vector2d& r, int direction, double h) {
  const Vector2d k1 = unit_direction(flow, r, direction);
  const Vector2d k2 = unit_direction(flow, r + h / 2 * k1, direction);
  const Vector2d k3 = unit_direction(flow, r + h / 2 * k2, direction);
  const Vector2d k4 = unit_direction(flow, r + h * k3, direction);
  return r + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

/// Outward normal of the nearest wall: gradient of the signed distance by central differences.
Vector2d wall_normal(const PlaneFlow& flow, const Vector2d& r) {
  constexpr double h = 1e-4;
  const Vector2d g(flow.distance(r.x() + h, r.y()) - flow.distance(r.x() - h, r.y()),
                   flow.distance(r.x(), r.y() + h) - flow.distance(r.x(), r.y() - h));
  return g.norm() > 0 ? Vector2d(g.normalized()) : Vector2d(Vector2d::Zero());
}

/// Sense in which the flow runs round a pillar: > 0 over its top. The tangent (n_y, -n_x) points up in
/// front of the pillar, forwards on top and backwards below, so one sign serves the whole front.
double sense_round_pillar(const PlaneFlow& flow, const Vector2d& r) {
  const Vector2d n = wall_normal(flow, r);
  return flow.velocity(r.x(), r.y()).dot(Vector2d(n.y(), -n.x()));
}

/// Does the streamline from y on the gap line pass above pillar (1,0)?
bool passes_above(const PlaneFlow& flow, double y, const StreamlineOptions& options) {
  const double line = flow.gap.x;
  const Streamline s = trace_streamline(flow, {line, y}, +1, line + flow.pitch_x, options);
  const Vector2d end = s.points.row(s.points.rows() - 1);
  if (s.end == StreamlineEnd::line) return end.y() > flow.row_shift + flow.gap.pillar_middle(flow.pitch_y);
  if (s.end == StreamlineEnd::too_long) return y > flow.gap.middle();
  // Ended on a wall: either side of the nearest pillar is known except for pillar (1,0) itself.
  const long row = std::lround(end.x() / flow.pitch_x);
  const long lane = std::lround((end.y() - static_cast<double>(row) * flow.row_shift) / flow.pitch_y);
  if (row <= 0) return lane >= 1;
  if (lane != 0) return lane > 0;
  return sense_round_pillar(flow, end) > 0;
}

/// Cuts a dividing streamline where it stops running into pillar (1,0) and turns round it.
Eigen::MatrixX2d cut_at_stagnation(const PlaneFlow& flow, const Eigen::MatrixX2d& points) {
  for (Eigen::Index k = 0; k < points.rows(); ++k) {
    const Vector2d r = points.row(k);
    if (r.x() < flow.gap.x + flow.pitch_x / 2 || flow.distance(r.x(), r.y()) > 2) continue;
    const Vector2d n = wall_normal(flow, r), u = flow.velocity(r.x(), r.y());
    if (std::abs(u.dot(n)) < std::abs(u.dot(Vector2d(n.y(), -n.x())))) return points.topRows(k);
  }
  return points;
}

/// Shortest distance between the points of a polyline and pillar (0,0).
double distance_to_first_pillar(const PlaneFlow& flow, const Eigen::MatrixX2d& points) {
  double shortest = HUGE_VAL;
  for (const auto& r : points.rowwise()) {
    if (std::abs(r.x()) > flow.pitch_x / 2 || r.y() > flow.pitch_y / 2) continue;
    shortest = std::min(shortest, flow.distance(r.x(), r.y()));
  }
  return shortest;
}

/// The same flow seen after r -> (-x, ny - y) and reversal of time: velocities keep their sign.
PlaneFlow reversed(const PlaneFlow& flow) {
  PlaneFlow r = flow;
  r.velocity = [&flow](double x, double y) { return flow.velocity(-x, flow.pitch_y - y); };
  r.distance = [&flow](double x, double y) { return flow.distance(-x, flow.pitch_y - y); };
  r.gap = {-flow.gap.x, flow.pitch_y - flow.gap.upper, flow.pitch_y - flow.gap.lower};
  return r;
}

/// The wall at y on the gap line to the last digit of the distance function, which lies in the direction
/// `into`
/// (+1 or -1) inside the pillar; y itself where the line runs along a wall.
double wall_on_line(const PlaneFlow& flow, double y, double into) {
  double inside = y + 0.125 * into, outside = y - 0.125 * into;
  const auto solid = [&](double at) { return flow.distance(flow.gap.x, at) < 0; };
  if (!solid(inside) || solid(outside)) return y;
  for (int k = 0; k < 50; ++k) {
    const double middle = (inside + outside) / 2;
    (solid(middle) ? inside : outside) = middle;
  }
  return (inside + outside) / 2;
}

}  // namespace

Streamline trace_streamline(const PlaneFlow& flow, const Vector2d& seed, int direction, double x_end,
                            const StreamlineOptions& options) {
  std::vector<Vector2d> points{seed};
  Streamline result;
  const double max_length = options.max_length_rows * flow.pitch_x;
  const double side = x_end >= seed.x() ? 1 : -1;
  Vector2d r = seed;
  for (double length = 0; length < max_length;) {
    const double wall = flow.distance(r.x(), r.y());
    if (wall < options.wall_distance) {
      result.end = StreamlineEnd::wall;
      break;
    }
    const double h = std::min(options.step, options.wall_step_ratio * wall);
    const Vector2d next = runge_kutta_step(flow, r, direction, h);
    // Opposite unit vectors cancel at a stagnation point: the step then covers next to no distance.
    if ((next - r).norm() < 1e-3 * h) {
      result.end = StreamlineEnd::stagnation;
      break;
    }
    if (side * (next.x() - x_end) >= 0) {
      points.push_back(r + (x_end - r.x()) / (next.x() - r.x()) * (next - r));
      result.end = StreamlineEnd::line;
      break;
    }
    length += h;
    r = next;
    points.push_back(r);
  }
  result.points.resize(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t k = 0; k < points.size(); ++k) {
    result.points.row(static_cast<Eigen::Index>(k)) = points[k].transpose();
  }
  return result;
}

Separation separation_downstream(const PlaneFlow& flow, const StreamlineOptions& options) {
  Separation result;
  constexpr double margin = 0.01;
  const GapLine gap{flow.gap.x, wall_on_line(flow, flow.gap.lower, -1),
                    wall_on_line(flow, flow.gap.upper, +1)};
  double below = gap.lower + margin, above = gap.upper - margin;
  // Without a row shift or a tilt the wakes and fronts of one lane face each other and divide nothing.
  if ((flow.row_shift == 0 && flow.tilt == 0) || passes_above(flow, below, options) ||
      !passes_above(flow, above, options)) {
    return result;
  }
  while (above - below > options.seed_tolerance) {
    const double y = (below + above) / 2;
    (passes_above(flow, y, options) ? above : below) = y;
  }
  result.found = true;
  result.seed = {gap.x, (below + above) / 2};
  result.seed_distance = result.seed.y() - gap.lower;

  const Eigen::MatrixX2d upstream =
      trace_streamline(flow, result.seed, -1, gap.x - flow.pitch_x / 2, options).points.colwise().reverse();
  const Eigen::MatrixX2d downstream =
      cut_at_stagnation(flow, trace_streamline(flow, result.seed, +1, gap.x + flow.pitch_x, options).points);
  result.streamline.resize(upstream.rows() + downstream.rows() - 1, 2);
  result.streamline << upstream, downstream.bottomRows(downstream.rows() - 1);
  result.minimum_distance = distance_to_first_pillar(flow, result.streamline);
  return result;
}

Separation separation_upstream(const PlaneFlow& flow, const StreamlineOptions& options) {
  Separation result = separation_downstream(reversed(flow), options);
  if (!result.found) return result;
  result.seed = {-result.seed.x(), flow.pitch_y - result.seed.y()};
  const Eigen::MatrixX2d mirrored = result.streamline.colwise().reverse();
  result.streamline.col(0) = -mirrored.col(0);
  result.streamline.col(1) = flow.pitch_y - mirrored.col(1).array();
  return result;
}

}  // namespace dld
