#pragma once
/// The row-shifted periodic array: pillars at (n nx, m ny + n d), n and m any whole numbers.
#include <array>
#include <cmath>
#include <memory>

#include "geometry/pillar.hpp"

namespace dld {

/// Point in the array reduced to the unit cell around pillar (0, 0).
struct ReducedPoint {
  double x = 0, y = 0;  ///< relative to the centre of the pillar of the cell
  long column = 0;      ///< n
  long lane = 0;        ///< m
};

/// Distances and normals to the nearest pillar of the whole array, lattice units.
class PillarArray {
 public:
  /// pitch_x, pitch_y and row_shift in lattice units; the shape's centre is the origin.
  PillarArray(std::shared_ptr<const PillarShape> shape, double pitch_x, double pitch_y, double row_shift)
      : shape_(std::move(shape)),
        reach_(shape_->bounding_radius()),
        pitch_x_(pitch_x),
        pitch_y_(pitch_y),
        row_shift_(row_shift) {}

  ReducedPoint reduce(double x, double y) const {
    const double n = std::nearbyint(x / pitch_x_);
    const double y_column = y - n * row_shift_;
    const double m = std::nearbyint(y_column / pitch_y_);
    return {x - n * pitch_x_, y_column - m * pitch_y_, static_cast<long>(n), static_cast<long>(m)};
  }

  /// Signed distance to the nearest pillar. Images n, m in -1, 0, 1 around the nearest one are checked,
  /// unless the point is so near to its own pillar that no image can be nearer; of the others those whose
  /// circumscribed circle is nearer.
  double signed_distance(double x, double y) const {
    constexpr double beyond = 1 + 1e-9;  // rounding must not leave out an image that is equally near
    const ReducedPoint p = reduce(x, y);
    double nearest = shape_->signed_distance(p.x, p.y);
    if (reach_ < 0 || nearest < 0.5 * std::min(pitch_x_, pitch_y_) - reach_) return nearest;
    for (int n = -1; n <= 1; ++n) {
      for (int m = -1; m <= 1; ++m) {
        if (n == 0 && m == 0) continue;
        const double x_image = p.x - n * pitch_x_, y_image = p.y - m * pitch_y_ - n * row_shift_;
        const double near = nearest + reach_;
        if (x_image * x_image + y_image * y_image > beyond * near * near) continue;
        nearest = std::min(nearest, shape_->signed_distance(x_image, y_image));
      }
    }
    return nearest;
  }

  /// Unit normal of the nearest surface, pointing into the fluid: the gradient of the distance by central
  /// differences, so that it holds for any shape.
  std::array<double, 2> normal(double x, double y) const {
    constexpr double h = 1e-4;
    const double gx = signed_distance(x + h, y) - signed_distance(x - h, y);
    const double gy = signed_distance(x, y + h) - signed_distance(x, y - h);
    const double norm = std::hypot(gx, gy);
    if (norm == 0.0) return {0.0, 0.0};
    return {gx / norm, gy / norm};
  }

  bool empty() const { return reach_ < 0; }
  const PillarShape& shape() const { return *shape_; }
  double pitch_x() const { return pitch_x_; }
  double pitch_y() const { return pitch_y_; }
  double row_shift() const { return row_shift_; }

 private:
  std::shared_ptr<const PillarShape> shape_;
  double reach_;  ///< of the shape from its centre; negative without pillars
  double pitch_x_, pitch_y_, row_shift_;
};

}  // namespace dld
