#pragma once
/// Inside/outside field of a closed membrane and the relaxation time that follows from it. Each lattice
/// column under the cell is cut with the triangles above and below it; the parity of the crossings tells
/// which nodes are inside. Exact for a closed mesh.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "fluid/lattice.hpp"

namespace dld {

/// Nodes of a box of columns, marked 1 inside and 0 outside; positions in lattice coordinates (not wrapped).
struct InsideField {
  int x0 = 0, y0 = 0, z0 = 0, nx = 0, ny = 0, nz = 0;
  std::vector<std::uint8_t> inside;  ///< index (x * ny + y) * nz + z
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nz) +
           static_cast<std::size_t>(z);
  }
};

/// Marks the nodes (x0 + i, y0 + j, z0 + k) inside the mesh; x (nv x 3) are lattice coordinates. The box has
/// one column of margin around the mesh. Layers z_first .. z_first + layers - 1 are looked at.
class InsideMarker {
 public:
  explicit InsideMarker(const Eigen::MatrixX3i& faces) : faces_(faces) {}
  const InsideField& mark(const Eigen::MatrixX3d& x, int z_first, int layers);
  /// Columns whose number of crossings was odd and that fell back to the winding number.
  long odd_columns() const { return odd_columns_; }

 private:
  void cut_columns(const Eigen::MatrixX3d& x);
  void fill_column(const Eigen::MatrixX3d& x, int i, int j, std::vector<double>& crossings);

  Eigen::MatrixX3i faces_;
  InsideField field_;
  std::vector<std::vector<double>> crossings_;
  long odd_columns_ = 0;
};

/// Solid angle of the mesh seen from a point, divided by 4 pi: 1 inside, 0 outside.
double winding_number(const Eigen::MatrixX3d& x, const Eigen::MatrixX3i& faces,
                      const Eigen::RowVector3d& point);

/// Keeps lattice.relaxation_time up to date with the cell's place.
template <class Real>
class ViscosityField {
 public:
  /// smoothed: the viscosity changes over about two nodes (1-2-1 filter of the sharp field).
  ViscosityField(Lattice<Real>& lattice, const Eigen::MatrixX3i& faces, double tau_outside, double tau_inside,
                 bool smoothed);
  /// x (nv x 3): physical lattice coordinates of the unit cell.
  void update(const Eigen::MatrixX3d& x);
  long odd_columns() const { return marker_.odd_columns(); }

 private:
  void set(int x, int y, int z, double inside_share);

  Lattice<Real>& lattice_;
  InsideMarker marker_;
  double tau_outside_, tau_inside_;
  bool smoothed_;
  std::vector<std::uint32_t> changed_;  ///< nodes with a relaxation time other than the outer one
  Eigen::MatrixX3d lattice_coordinates_;
};

extern template class ViscosityField<float>;
extern template class ViscosityField<double>;

}  // namespace dld
