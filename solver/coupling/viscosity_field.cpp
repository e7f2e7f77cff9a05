#include "coupling/viscosity_field.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace dld {
namespace {

/// On which side of the edge a -> b the point lies. The two faces of an edge evaluate the very same numbers
/// (lower index first), and a point on the edge's line counts as moved by (d, d^2), d infinitesimal: a column
/// through an edge or a vertex belongs to exactly one face of the upper and one of the lower side
/// (Edelsbrunner and Muecke 1990, simulation of simplicity).
bool left_of(const Eigen::MatrixX3d& x, int a, int b, double px, double py) {
  const bool swapped = b < a;
  if (swapped) std::swap(a, b);
  // Relative to the point, so that a point on a or b gives exactly zero.
  const double ax = x(a, 0) - px, ay = x(a, 1) - py, bx = x(b, 0) - px, by = x(b, 1) - py;
  const double area = ax * by - ay * bx;
  const bool left = area != 0.0 ? area > 0.0 : ay > by || (ay == by && bx > ax);
  return left != swapped;
}

}  // namespace

double winding_number(const Eigen::MatrixX3d& x, const Eigen::MatrixX3i& faces,
                      const Eigen::RowVector3d& point) {
  // Solid angle of a triangle: van Oosterom and Strackee 1983.
  double angle = 0.0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector3d a = x.row(faces(f, 0)) - point, b = x.row(faces(f, 1)) - point,
                             c = x.row(faces(f, 2)) - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle +=
        2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

const InsideField& InsideMarker::mark(const Eigen::MatrixX3d& x, int z_first, int layers) {
  constexpr int margin = 1;
  const auto low = [&](int axis) { return static_cast<int>(std::floor(x.col(axis).minCoeff())) - margin; };
  const auto high = [&](int axis) { return static_cast<int>(std::ceil(x.col(axis).maxCoeff())) + margin; };
  field_.x0 = low(0);
  field_.y0 = low(1);
  field_.z0 = z_first;
  field_.nx = high(0) - field_.x0 + 1;
  field_.ny = high(1) - field_.y0 + 1;
  field_.nz = layers;
  const std::size_t columns = static_cast<std::size_t>(field_.nx) * static_cast<std::size_t>(field_.ny);
  field_.inside.assign(columns * static_cast<std::size_t>(layers), 0);
  if (crossings_.size() < columns) crossings_.resize(columns);
  for (std::size_t column = 0; column < columns; ++column) crossings_[column].clear();
  cut_columns(x);
  for (int i = 0; i < field_.nx; ++i) {
    for (int j = 0; j < field_.ny; ++j) {
      auto& crossings = crossings_[static_cast<std::size_t>(i) * static_cast<std::size_t>(field_.ny) +
                                   static_cast<std::size_t>(j)];
      if (!crossings.empty()) fill_column(x, i, j, crossings);
    }
  }
  return field_;
}

void InsideMarker::cut_columns(const Eigen::MatrixX3d& x) {
  for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
    const int a = faces_(f, 0), b = faces_(f, 1), c = faces_(f, 2);
    const auto [x_min, x_max] = std::minmax({x(a, 0), x(b, 0), x(c, 0)});
    const auto [y_min, y_max] = std::minmax({x(a, 1), x(b, 1), x(c, 1)});
    for (int px = static_cast<int>(std::ceil(x_min)); px <= x_max; ++px) {
      for (int py = static_cast<int>(std::ceil(y_min)); py <= y_max; ++py) {
        const bool ab = left_of(x, a, b, px, py), bc = left_of(x, b, c, px, py),
                   ca = left_of(x, c, a, px, py);
        if (ab != bc || bc != ca) continue;
        // Height of the triangle's plane over the column.
        const double ux = x(b, 0) - x(a, 0), uy = x(b, 1) - x(a, 1), vx = x(c, 0) - x(a, 0),
                     vy = x(c, 1) - x(a, 1);
        const double area = ux * vy - uy * vx;
        if (area == 0.0) continue;
        const double s = ((px - x(a, 0)) * vy - (py - x(a, 1)) * vx) / area;
        const double t = (ux * (py - x(a, 1)) - uy * (px - x(a, 0))) / area;
        crossings_[static_cast<std::size_t>(px - field_.x0) * static_cast<std::size_t>(field_.ny) +
                   static_cast<std::size_t>(py - field_.y0)]
            .push_back(x(a, 2) + s * (x(b, 2) - x(a, 2)) + t * (x(c, 2) - x(a, 2)));
      }
    }
  }
}

void InsideMarker::fill_column(const Eigen::MatrixX3d& x, int i, int j, std::vector<double>& crossings) {
  if (crossings.size() % 2 == 1) {
    ++odd_columns_;
    for (int k = 0; k < field_.nz; ++k) {
      const Eigen::RowVector3d point(field_.x0 + i, field_.y0 + j, field_.z0 + k);
      field_.inside[field_.index(i, j, k)] = winding_number(x, faces_, point) > 0.5 ? 1 : 0;
    }
    return;
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t pair = 0; pair + 1 < crossings.size(); pair += 2) {
    const int first = std::max(0, static_cast<int>(std::ceil(crossings[pair])) - field_.z0);
    const int last = std::min(field_.nz - 1, static_cast<int>(std::floor(crossings[pair + 1])) - field_.z0);
    for (int k = first; k <= last; ++k) field_.inside[field_.index(i, j, k)] = 1;
  }
}

template <class Real>
ViscosityField<Real>::ViscosityField(Lattice<Real>& lattice, const Eigen::MatrixX3i& faces,
                                     double tau_outside, double tau_inside, bool smoothed)
    : lattice_(lattice),
      marker_(faces),
      tau_outside_(tau_outside),
      tau_inside_(tau_inside),
      smoothed_(smoothed) {}

template <class Real>
void ViscosityField<Real>::update(const Eigen::MatrixX3d& x) {
  for (const std::uint32_t node : changed_) lattice_.relaxation_time[node] = static_cast<Real>(tau_outside_);
  changed_.clear();
  if (tau_inside_ == tau_outside_) return;
  const UnitCell& cell = lattice_.cell();
  lattice_coordinates_ = x;
  lattice_coordinates_.col(0).array() -= cell.origin_x;
  lattice_coordinates_.col(1).array() -= cell.origin_y;
  lattice_coordinates_.col(2).array() -= cell.origin_z;
  // One layer more on either side serves the filter; beyond the mirror plane the mesh itself continues.
  const InsideField& field = marker_.mark(lattice_coordinates_, -1, cell.nz + 2);
  const auto marked = [&](int i, int j, int k) {
    if (i < 0 || j < 0 || k < 0 || i >= field.nx || j >= field.ny || k >= field.nz) return 0.0;
    return static_cast<double>(field.inside[field.index(i, j, k)]);
  };
  for (int i = 0; i < field.nx; ++i) {
    for (int j = 0; j < field.ny; ++j) {
      for (int k = 1; k <= cell.nz; ++k) {
        double share = marked(i, j, k);
        if (smoothed_) {
          share = 0.0;
          for (int a = -1; a <= 1; ++a) {
            for (int b = -1; b <= 1; ++b) {
              for (int c = -1; c <= 1; ++c) {
                share +=
                    (2 - std::abs(a)) * (2 - std::abs(b)) * (2 - std::abs(c)) * marked(i + a, j + b, k + c);
              }
            }
          }
          share /= 64.0;
        }
        if (share > 0.0) set(field.x0 + i, field.y0 + j, k - 1, share);
      }
    }
  }
}

template <class Real>
void ViscosityField<Real>::set(int x, int y, int z, double inside_share) {
  const NodeImage image = lattice_.cell().wrap(x, y, z);
  const std::uint32_t node = lattice_.layout().node(image.x, image.y, image.z);
  // Viscosity is linear in the inside share, and so is tau.
  lattice_.relaxation_time[node] =
      static_cast<Real>(tau_outside_ + inside_share * (tau_inside_ - tau_outside_));
  changed_.push_back(node);
}

template class ViscosityField<float>;
template class ViscosityField<double>;

}  // namespace dld
