#include "geometry/pillar_surface.hpp"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace dld {
namespace {

/// Zero line of a distance function as segments between points on grid edges.
class Outline {
 public:
  Outline(const PillarShape& shape, int resolution) : shape_(shape), n_(resolution + 1) {
    // A margin keeps the zero line off the edge of the grid.
    const double reach = 1.05 * shape.bounding_radius();
    spacing_ = 2 * reach / resolution;
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j) nodes_.push_back({i * spacing_ - reach, j * spacing_ - reach});
    }
    for (const auto& p : nodes_) distances_.push_back(shape.signed_distance(p[0], p[1]));
    for (int i = 0; i + 1 < n_; ++i) {
      for (int j = 0; j + 1 < n_; ++j) {
        const int a = i * n_ + j, b = a + n_, c = b + 1, d = a + 1;
        cut({a, b, c});
        cut({a, c, d});
      }
    }
  }

  std::vector<std::array<double, 2>> points;
  std::vector<std::array<int, 2>> segments;

 private:
  bool inside(int node) const { return distances_[node] < 0; }

  void cut(const std::array<int, 3>& corners) {
    std::vector<int> ends;
    for (int k = 0; k < 3; ++k) {
      const int p = corners[k], q = corners[(k + 1) % 3];
      if (inside(p) != inside(q)) ends.push_back(crossing(p, q));
    }
    if (ends.size() == 2) segments.push_back({ends[0], ends[1]});
  }

  /// The point of the surface between two nodes, found once for both triangles of an edge.
  int crossing(int p, int q) {
    const auto [place, added] = known_.try_emplace(std::minmax(p, q), static_cast<int>(points.size()));
    if (!added) return place->second;
    std::array<double, 2> in = nodes_[inside(p) ? p : q], out = nodes_[inside(p) ? q : p], middle = in;
    constexpr int halvings = 40;
    for (int k = 0; k < halvings; ++k) {
      middle = {0.5 * (in[0] + out[0]), 0.5 * (in[1] + out[1])};
      (shape_.signed_distance(middle[0], middle[1]) < 0 ? in : out) = middle;
    }
    points.push_back(middle);
    return place->second;
  }

  const PillarShape& shape_;
  int n_;
  double spacing_ = 0;
  std::vector<std::array<double, 2>> nodes_;
  std::vector<double> distances_;
  std::map<std::pair<int, int>, int> known_;
};

}  // namespace

Surface pillar_wall(const PillarShape& shape, double half_height, int resolution) {
  if (shape.bounding_radius() < 0) return {};
  const Outline outline(shape, resolution);
  const auto n = static_cast<Eigen::Index>(outline.points.size());
  const auto m = static_cast<Eigen::Index>(outline.segments.size());
  Surface wall{Eigen::MatrixX3d(2 * n, 3), Eigen::MatrixX3i(2 * m, 3)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& p = outline.points[static_cast<std::size_t>(i)];
    wall.vertices.row(i) << p[0], p[1], -half_height;
    wall.vertices.row(n + i) << p[0], p[1], half_height;
  }
  const auto top = static_cast<int>(n);
  for (Eigen::Index k = 0; k < m; ++k) {
    const auto [a, b] = outline.segments[static_cast<std::size_t>(k)];
    wall.triangles.row(2 * k) << a, b, top + b;
    wall.triangles.row(2 * k + 1) << a, top + b, top + a;
  }
  return wall;
}

}  // namespace dld
