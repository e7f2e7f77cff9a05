#include "geometry/contour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/text.hpp"

namespace dld {
namespace {

// Corners that turn by less (rad) count as points of a straight edge.
constexpr double straight = 1e-6;

double cross(const Point2& a, const Point2& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Point2 difference(const Point2& a, const Point2& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

double length(const Point2& a) {
  return std::hypot(a[0], a[1]);
}

std::string text(const Point2& p) {
  return "[" + number_text(p[0]) + ", " + number_text(p[1]) + "]";
}

/// Angle by which the direction turns at point i, positive at a corner that points out (rad).
double turn(const std::vector<Point2>& points, std::size_t i) {
  const std::size_t n = points.size();
  const Point2 in = difference(points[i], points[(i + n - 1) % n]);
  const Point2 out = difference(points[(i + 1) % n], points[i]);
  return std::atan2(cross(in, out), in[0] * out[0] + in[1] * out[1]);
}

/// How far from corner i an arc of radius 1 touches the edges; 0 at a corner that is not rounded.
double tangent_length(const std::vector<Point2>& points, std::size_t i) {
  return std::tan(0.5 * std::max(0.0, turn(points, i)));
}

/// Do the segments a-b and c-d have a point in common?
bool meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto side = [](const Point2& p, const Point2& q, const Point2& r) {
    return cross(difference(q, p), difference(r, p));
  };
  const auto within = [](const Point2& p, const Point2& q, const Point2& r) {
    return std::min(p[0], q[0]) <= r[0] && r[0] <= std::max(p[0], q[0]) && std::min(p[1], q[1]) <= r[1] &&
           r[1] <= std::max(p[1], q[1]);
  };
  const double c1 = side(a, b, c), d1 = side(a, b, d), a1 = side(c, d, a), b1 = side(c, d, b);
  if (((c1 > 0 && d1 < 0) || (c1 < 0 && d1 > 0)) && ((a1 > 0 && b1 < 0) || (a1 < 0 && b1 > 0))) return true;
  return (c1 == 0 && within(a, b, c)) || (d1 == 0 && within(a, b, d)) || (a1 == 0 && within(c, d, a)) ||
         (b1 == 0 && within(c, d, b));
}

}  // namespace

double polygon_area(const std::vector<Point2>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) twice += cross(points[i], points[(i + 1) % points.size()]);
  return 0.5 * twice;
}

double largest_corner_radius(const std::vector<Point2>& points) {
  const std::size_t n = points.size();
  double largest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const double used = tangent_length(points, i) + tangent_length(points, next);
    if (used > 0) largest = std::min(largest, length(difference(points[next], points[i])) / used);
  }
  return largest;
}

Contour::Contour(const std::vector<Point2>& points, const std::vector<double>& radii) {
  const std::size_t n = points.size();
  area_ = polygon_area(points);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Point2 along = difference(points[next], points[i]);
    const double whole = length(along), tx = along[0] / whole, ty = along[1] / whole;
    const double angle = turn(points, i), angle_next = turn(points, next);
    const double radius = radii.at(i), cut = radius * tangent_length(points, i);
    const double cut_next = radii.at(next) * tangent_length(points, next);
    edges_.push_back({{points[i][0] + cut * tx, points[i][1] + cut * ty},
                      tx,
                      ty,
                      std::max(0.0, whole - cut - cut_next),
                      cut == 0 && std::abs(angle) > straight,
                      cut_next == 0 && std::abs(angle_next) > straight,
                      angle > 0,
                      angle_next > 0});
    Arc arc{};
    if (cut > 0) {
      const Point2& start =
          edges_.back().start;  // where the arc ends; its centre lies on the left of the edge
      arc.centre = {start[0] - radius * ty, start[1] + radius * tx};
      arc.radius = radius;
      arc.angle = angle;
      arc.start = std::atan2(-tx, ty) - angle;
      arc.mx = std::cos(arc.start + angle / 2), arc.my = std::sin(arc.start + angle / 2);
      arc.cos2_half = std::pow(std::cos(angle / 2), 2);
      area_ -= radius * (cut - 0.5 * angle * radius);
    }
    arcs_.push_back(arc);
  }
  for (const Point2& p : outline()) bounding_radius_ = std::max(bounding_radius_, length(p));
  for (const Arc& arc : arcs_) {
    if (arc.radius > 0) bounding_radius_ = std::max(bounding_radius_, length(arc.centre) + arc.radius);
  }
}

double Contour::signed_distance(double x, double y) const {
  double nearest = std::numeric_limits<double>::max();  // squared
  bool inside = false;
  for (const Edge& e : edges_) {
    const double dx = x - e.start[0], dy = y - e.start[1];
    const double along = dx * e.tx + dy * e.ty, side = dy * e.tx - dx * e.ty;
    const double beyond = along < 0 ? along : std::max(0.0, along - e.length);
    const double squared = beyond * beyond + side * side;
    if (squared >= nearest) continue;
    nearest = squared;
    // Nearest to a corner: outside if it points out, inside if it is re-entrant.
    inside = along < 0 && e.sharp_start        ? !e.convex_start
             : along > e.length && e.sharp_end ? !e.convex_end
                                               : side > 0;
  }
  for (const Arc& arc : arcs_) {
    if (arc.radius == 0) continue;
    const double dx = x - arc.centre[0], dy = y - arc.centre[1];
    // Few points lie in the sector of an arc: the root is taken for them alone.
    const double squared = dx * dx + dy * dy, ahead = dx * arc.mx + dy * arc.my;
    if (ahead < 0 || ahead * ahead < squared * arc.cos2_half) continue;
    const double off = std::sqrt(squared) - arc.radius;
    if (off * off >= nearest) continue;
    nearest = off * off;
    inside = off < 0;
  }
  return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

std::vector<Point2> Contour::outline() const {
  std::vector<Point2> points;
  const std::size_t n = edges_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Arc& arc = arcs_[i];
    if (arc.radius > 0) {
      const int steps = static_cast<int>(std::ceil(arc.angle / PillarShape::curve_step));
      for (int k = 0; k < steps; ++k) {
        const double at = arc.start + arc.angle * k / steps;
        points.push_back(
            {arc.centre[0] + arc.radius * std::cos(at), arc.centre[1] + arc.radius * std::sin(at)});
      }
    }
    points.push_back(edges_[i].start);
  }
  return points;
}

std::vector<PillarProblem> polygon_problems(const std::string& name, const std::vector<Point2>& points) {
  const std::size_t n = points.size();
  if (n < 3) return {{name, std::to_string(n) + " points", "at least 3 points", "add the missing corners"}};
  std::vector<PillarProblem> problems;
  for (std::size_t i = 0; i < n; ++i) {
    if (points[i] != points[(i + 1) % n]) continue;
    problems.push_back({name, text(points[i]), "each corner once; the last joins the first by itself",
                        "remove point " + std::to_string((i + 1) % n) + ", counted from 0"});
  }
  if (!problems.empty()) return problems;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours
      if (!meet(points[i], points[i + 1], points[j], points[(j + 1) % n])) continue;
      problems.push_back({name, text(points[i]) + " to " + text(points[i + 1]),
                          "a line that does not touch itself",
                          "it meets the edge from " + text(points[j]) + " to " + text(points[(j + 1) % n]) +
                              "; list the corners in their order along the outline"});
    }
    // An edge that runs back along the one before.
    if (std::abs(turn(points, i)) > std::numbers::pi - 1e-9) {
      problems.push_back({name, text(points[i]), "a line that does not run back along itself", "remove it"});
    }
  }
  if (problems.empty() && polygon_area(points) < 0) {
    problems.push_back(
        {name, "clockwise", "points in counter-clockwise order", "list them the other way round"});
  }
  return problems;
}

std::vector<PillarProblem> corner_problems(const std::vector<Point2>& points, double corner_radius) {
  const double largest = largest_corner_radius(points);
  if (corner_radius > largest * (1 + 1e-9)) {
    return {{"corner_radius_um", number_text(corner_radius),
             "at most " + number_text(largest) + ", the largest that fits between two corners",
             "use at most " + number_text(std::floor(1e3 * largest) / 1e3)}};
  }
  // What is cut off a corner lies in a triangle, into which no other part of the outline may reach.
  std::vector<PillarProblem> problems;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double cut = corner_radius * tangent_length(points, i);
    if (cut == 0) continue;
    const auto towards = [&](const Point2& to) {
      const Point2 way = difference(to, points[i]);
      const double share = cut / length(way);
      return Point2{points[i][0] + share * way[0], points[i][1] + share * way[1]};
    };
    const Point2 before = towards(points[(i + n - 1) % n]), after = towards(points[(i + 1) % n]);
    for (const Point2& p : points) {
      const bool within = cross(difference(points[i], before), difference(p, before)) > 0 &&
                          cross(difference(after, points[i]), difference(p, points[i])) > 0 &&
                          cross(difference(before, after), difference(p, after)) > 0;
      if (!within) continue;
      problems.push_back(
          {"corner_radius_um", number_text(corner_radius),
           "less than what reaches from the corner " + text(points[i]) + " to the corner " + text(p),
           "use a smaller radius"});
    }
  }
  return problems;
}

}  // namespace dld
