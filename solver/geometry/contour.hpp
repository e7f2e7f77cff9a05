#pragma once
/// Closed line of straight edges and arcs: what pillars with corners are made of.
#include <string>
#include <vector>

#include "geometry/pillar.hpp"

namespace dld {

class Contour {
 public:
  /// Simple polygon (at least three points, counter-clockwise). A corner that points out is rounded by an arc
  /// of its radius inside the polygon; a re-entrant one stays as it is. One radius per point.
  Contour(const std::vector<Point2>& points, const std::vector<double>& radii);

  /// Exact distance, negative inside: that to the nearest edge or arc, its sign that of the side.
  double signed_distance(double x, double y) const;
  double bounding_radius() const { return bounding_radius_; }
  double area() const { return area_; }
  std::vector<Point2> outline() const;

 private:
  /// From start to end, along the unit vector (tx, ty), inside on its left. A sharp end is a corner.
  struct Edge {
    Point2 start;
    double tx, ty, length;
    bool sharp_start, sharp_end, convex_start, convex_end;
  };
  /// An arc that bulges out, from `start` counter-clockwise by `angle` (rad) about the centre.
  struct Arc {
    Point2 centre;
    double radius, start, angle;
    double mx, my;     ///< unit vector to its middle
    double cos2_half;  ///< squared cosine of half the angle, which is below a right angle
  };
  std::vector<Edge> edges_;
  std::vector<Arc> arcs_;  ///< arc i stands at the start of edge i; radius 0 where the corner is sharp
  double bounding_radius_ = 0, area_ = 0;
};

/// Area that the polygon encloses, positive if it is counter-clockwise (Gauss's shoelace formula).
double polygon_area(const std::vector<Point2>& points);

/// Largest radius that fits into every corner that points out.
double largest_corner_radius(const std::vector<Point2>& points);

/// What is wrong with the points of an outline: too few, repeated, clockwise, crossing itself. `name` is the
/// parameter that the points were given as.
std::vector<PillarProblem> polygon_problems(const std::string& name, const std::vector<Point2>& points);

/// The problem of a corner radius that does not fit, if there is one.
std::vector<PillarProblem> corner_problems(const std::vector<Point2>& points, double corner_radius);

}  // namespace dld
