#include "measure/cross_section.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
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

std::vector<double> PassageExtent::numbers() const {
  return {x_line_,
          max_width_,
          width_at_centre_,
          height_at_max_,
          min_film_,
          step_at_centre_,
          y_at_centre_,
          static_cast<double>(step_at_max_),
          centre_passed_ ? 1.0 : 0.0,
          passed_ ? 1.0 : 0.0,
          has_previous_ ? 1.0 : 0.0,
          previous_.centre.x(),
          previous_.centre.y(),
          previous_.centre.z(),
          previous_.width,
          static_cast<double>(previous_.step)};
}

PassageExtent PassageExtent::from(const std::vector<double>& numbers, Eigen::MatrixX3d vertices_at_max) {
  const auto& n = numbers;
  PassageExtent extent(n.at(0));
  if (n.size() != extent.numbers().size()) throw std::invalid_argument("not the numbers of a PassageExtent");
  extent.max_width_ = n[1];
  extent.width_at_centre_ = n[2];
  extent.height_at_max_ = n[3];
  extent.min_film_ = n[4];
  extent.step_at_centre_ = n[5];
  extent.y_at_centre_ = n[6];
  extent.step_at_max_ = static_cast<long>(n[7]);
  extent.centre_passed_ = n[8] != 0.0;
  extent.passed_ = n[9] != 0.0;
  extent.has_previous_ = n[10] != 0.0;
  extent.previous_ = {{n[11], n[12], n[13]}, n[14], static_cast<long>(n[15])};
  extent.vertices_at_max_ = std::move(vertices_at_max);
  return extent;
}

}  // namespace dld
