#include "measure/cross_section.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace dld {
namespace {

/// Point (y, z) where the edge a-b cuts the plane x = x0.
Eigen::RowVector2d cut_point(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, double x0) {
  return a.tail<2>() + (x0 - a.x()) / (b.x() - a.x()) * (b.tail<2>() - a.tail<2>());
}

}  // namespace

CrossSection cross_section(const Eigen::MatrixX3d& vertices, const Eigen::MatrixX3i& faces, double x0) {
  CrossSection section;
  std::vector<Eigen::RowVector4d> segments;
  for (const auto& face : faces.rowwise()) {
    std::array<bool, 3> behind{};
    for (int k = 0; k < 3; ++k) behind[static_cast<std::size_t>(k)] = vertices(face(k), 0) <= x0;
    if (behind[0] == behind[1] && behind[1] == behind[2]) continue;
    Eigen::RowVector4d segment;
    int ends = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (behind[static_cast<std::size_t>(k)] == behind[static_cast<std::size_t>(next)]) continue;
      segment.segment<2>(2 * ends++) = cut_point(vertices.row(face(k)), vertices.row(face(next)), x0);
    }
    segments.push_back(segment);
  }
  if (segments.empty()) return section;

  section.segments.resize(static_cast<Eigen::Index>(segments.size()), 4);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    section.segments.row(static_cast<Eigen::Index>(k)) = segments[k];
  }
  // Both ends of the segments are needed only for an open mesh, but cost nothing.
  section.min_y = std::min(section.segments.col(0).minCoeff(), section.segments.col(2).minCoeff());
  section.max_y = std::max(section.segments.col(0).maxCoeff(), section.segments.col(2).maxCoeff());
  section.min_z = std::min(section.segments.col(1).minCoeff(), section.segments.col(3).minCoeff());
  section.max_z = std::max(section.segments.col(1).maxCoeff(), section.segments.col(3).maxCoeff());
  section.width = section.max_y - section.min_y;
  section.height = section.max_z - section.min_z;
  return section;
}

void PassageExtent::interpolate_centre(const Sample& before, const Sample& after) {
  const double t = (x_line_ - before.centre.x()) / (after.centre.x() - before.centre.x());
  width_at_centre_ = before.width + t * (after.width - before.width);
  y_at_centre_ = before.centre.y() + t * (after.centre.y() - before.centre.y());
  step_at_centre_ = static_cast<double>(before.step) + t * static_cast<double>(after.step - before.step);
  centre_passed_ = true;
}

void PassageExtent::update(const Eigen::MatrixX3d& vertices, const Eigen::MatrixX3i& faces,
                           const Eigen::Vector3d& centre, double film, long step) {
  const CrossSection section = cross_section(vertices, faces, x_line_);
  if (section.width > 0) min_film_ = std::min(min_film_, film);
  if (section.width > max_width_) {
    max_width_ = section.width;
    height_at_max_ = section.height;
    step_at_max_ = step;
    vertices_at_max_ = vertices;
  }
  const Sample sample{centre, section.width, step};
  if (has_previous_ && !centre_passed_ && previous_.centre.x() < x_line_ && centre.x() >= x_line_) {
    interpolate_centre(previous_, sample);
  }
  previous_ = sample;
  has_previous_ = true;
  passed_ = vertices.col(0).minCoeff() > x_line_;
}

}  // namespace dld
