#pragma once
/// Section of the membrane with a pillar line and the lateral extent D_perp of the cell on it. Lattice units.
#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace dld {

/// Section of a closed triangle mesh with the plane x = x0.
struct CrossSection {
  double width = 0;   ///< lateral extent max y - min y (lu); 0 when the plane misses the cell
  double height = 0;  ///< extent max z - min z (lu)
  double min_y = 0, max_y = 0, min_z = 0, max_z = 0;
  Eigen::MatrixX4d segments;  ///< (n, 4) rows y1, z1, y2, z2 (lu): the outline, one segment per cut triangle
};

/// vertices (nv, 3) lu; faces (nf, 3) vertex indices of a closed mesh. A vertex
/// exactly on the plane counts as lying behind it, so that each edge is cut once or not at all.
CrossSection cross_section(const Eigen::MatrixX3d& vertices, const Eigen::MatrixX3i& faces, double x0);

/// Follows a cell past one pillar line and keeps what the paper's D_perp needs.
class PassageExtent {
 public:
  /// x_line: the pillar line x = n nx (lu).
  explicit PassageExtent(double x_line) : x_line_(x_line) {}

  /// One sample along the passage, in the order of time. centre: centroid of the cell (lu); film: smallest
  /// distance between the membrane and a pillar (lu); height and shape are taken from the vertices.
  void update(const Eigen::MatrixX3d& vertices, const Eigen::MatrixX3i& faces, const Eigen::Vector3d& centre,
              double film, long step);

  bool reached() const { return max_width_ > 0; }        ///< the line has cut the cell
  bool centre_passed() const { return centre_passed_; }  ///< the centroid has crossed the line
  bool passed() const { return passed_; }                ///< the whole cell is beyond the line

  double x_line() const { return x_line_; }
  double max_width() const { return max_width_; }              ///< D_perp: maximum over the passage (lu)
  double width_at_centre() const { return width_at_centre_; }  ///< D_perp with the centroid on the line (lu)
  double height_at_max() const { return height_at_max_; }  ///< z extent of the section at the maximum (lu)
  double min_film() const { return min_film_; }            ///< while the line cuts the cell (lu)
  long step_at_max() const { return step_at_max_; }
  double step_at_centre() const { return step_at_centre_; }  ///< interpolated between samples
  double y_at_centre() const { return y_at_centre_; }        ///< y of the centroid on the line (lu)
  const Eigen::MatrixX3d& vertices_at_max() const { return vertices_at_max_; }  ///< (nv, 3) lu

  /// All it knows besides vertices_at_max(), in an order of its own, and the way back: for a checkpoint in
  /// the middle of a passage.
  std::vector<double> numbers() const;
  static PassageExtent from(const std::vector<double>& numbers, Eigen::MatrixX3d vertices_at_max);

 private:
  struct Sample {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double width = 0;
    long step = 0;
  };
  void interpolate_centre(const Sample& before, const Sample& after);

  double x_line_;
  double max_width_ = 0, width_at_centre_ = 0, height_at_max_ = 0, min_film_ = HUGE_VAL;
  double step_at_centre_ = 0, y_at_centre_ = 0;
  long step_at_max_ = 0;
  bool centre_passed_ = false, passed_ = false, has_previous_ = false;
  Sample previous_{};
  Eigen::MatrixX3d vertices_at_max_;
};

}  // namespace dld
