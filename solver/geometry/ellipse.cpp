#include "geometry/ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dld {

std::vector<PillarParameter> Ellipse::parameters() {
  return {{.name = "semi_axes_um",
           .kind = PillarParameter::Kind::pair,
           .example = {12, 7},
           .minimum = 0,
           .maximum = 1000,
           .open_minimum = true,
           .unit = "um",
           .doc = "a along x and b along y, before the rotation"},
          {.name = "rotation_deg",
           .fallback = 0,
           .example = {20},
           .minimum = -360,
           .maximum = 360,
           .unit = "degrees",
           .doc = "rotation about the centre, counter-clockwise"}};
}

Ellipse Ellipse::from(const PillarValues& values) {
  const Point2 axes = values.points("semi_axes_um").at(0);
  return {axes[0], axes[1], values.number("rotation_deg") * std::numbers::pi / 180};
}

Ellipse::Ellipse(double a, double b, double rotation)
    : a_(a), b_(b), cos_(std::cos(rotation)), sin_(std::sin(rotation)) {}

// The nearest point (a^2 x / (t + a^2), b^2 y / (t + b^2)) lies on the ellipse for the largest root t of
//   F(t) = (a x / (t + a^2))^2 + (b y / (t + b^2))^2 - 1
// (Eberly, Distance from a point to an ellipse, 2013). F falls and is convex beyond t = -min(a, b)^2, so that
// Newton's method from where one term alone is 1 climbs to the root and never beyond it. In the first
// quadrant, with a >= b.
double Ellipse::signed_distance(double px, double py) const {
  double x = std::abs(cos_ * px + sin_ * py), y = std::abs(cos_ * py - sin_ * px);
  double a = a_, b = b_;
  if (a < b) std::swap(a, b), std::swap(x, y);
  const double u = x / a, v = y / b, ratio = (a / b) * (a / b);
  double nearest_x = 0, nearest_y = 0;
  if (v > 0) {
    // In s = t / b^2 + 1 > 0: F = (ratio u / (s + ratio - 1))^2 + (v / s)^2 - 1.
    double s = std::max(v, ratio * u - ratio + 1);
    for (int k = 0; k < 100; ++k) {
      const double p = ratio * u / (s + ratio - 1), q = v / s;
      const double next = s + 0.5 * (p * p + q * q - 1) / (p * p / (s + ratio - 1) + q * q / s);
      if (!(next > s)) break;
      s = next;
    }
    nearest_x = ratio * x / (s + ratio - 1), nearest_y = y / s;
  } else if (ratio * u < ratio - 1) {
    // On the long axis, between the centres of curvature of its ends: two points are equally near.
    const double c = ratio * u / (ratio - 1);
    nearest_x = a * c, nearest_y = b * std::sqrt(std::max(0.0, 1 - c * c));
  } else {
    nearest_x = a;
  }
  const double distance = std::hypot(x - nearest_x, y - nearest_y);
  return u * u + v * v < 1 ? -distance : distance;
}

double Ellipse::bounding_radius() const {
  return std::max(a_, b_);
}

double Ellipse::area() const {
  return std::numbers::pi * a_ * b_;
}

std::vector<Point2> Ellipse::outline() const {
  constexpr int n = 72;  // curve_step, of the eccentric angle
  std::vector<Point2> points;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    const double x = a_ * std::cos(angle), y = b_ * std::sin(angle);
    points.push_back({cos_ * x - sin_ * y, sin_ * x + cos_ * y});
  }
  return points;
}

}  // namespace dld
