#include "geometry/pillar_surface.hpp"

#include <vector>

namespace dld {

Surface pillar_wall(const PillarShape& shape, double half_height) {
  const std::vector<Point2> outline = shape.outline();
  const auto n = static_cast<Eigen::Index>(outline.size());
  Surface wall{Eigen::MatrixX3d(2 * n, 3), Eigen::MatrixX3i(2 * n, 3)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point2& p = outline[static_cast<std::size_t>(i)];
    wall.vertices.row(i) << p[0], p[1], -half_height;
    wall.vertices.row(n + i) << p[0], p[1], half_height;
    const auto a = static_cast<int>(i), b = static_cast<int>((i + 1) % n), top = static_cast<int>(n);
    wall.triangles.row(2 * i) << a, b, top + b;
    wall.triangles.row(2 * i + 1) << a, top + b, top + a;
  }
  return wall;
}

}  // namespace dld
