#pragma once
/// Velocity of the mid plane of the unit cell, interpolated between the nodes and continued to the whole
/// array. Lattice units; the origin is the centre of pillar (0,0); pillar (n,m) stands at
/// (n nx, m ny + n d) and the field repeats as phi(x + nx, y) = phi(x, y - d).
#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "geometry/gap_line.hpp"

namespace dld {

/// Signed distance (lu) to the nearest pillar of the whole array, negative inside.
using DistanceFunction = std::function<double(double x, double y)>;
/// In-plane velocity (lu) at any point of the array.
using VelocityFunction = std::function<Eigen::Vector2d(double x, double y)>;

/// A flow through the array as the streamline measurements see it.
struct PlaneFlow {
  VelocityFunction velocity;
  DistanceFunction distance;
  double pitch_x = 0;    ///< nx (lu)
  double pitch_y = 0;    ///< ny (lu)
  double row_shift = 0;  ///< d (lu)
  GapLine gap;           ///< where s is measured (lu)
  double tilt = 0;       ///< of the rows against the driving force (rad)
};

/// Solid flags on the nodes: non-zero inside a pillar.
using SolidFlags = Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>;

class PlaneField {
 public:
  /// u, v: velocity (lu) on nodes (i, j) at (i + x0, j + y0), shape nx x ny; row_shift: d (whole, lu).
  /// The distance function may be empty: then solid nodes count as zero velocity (less accurate).
  PlaneField(Eigen::ArrayXXd u, Eigen::ArrayXXd v, SolidFlags solid, double x0, double y0, int row_shift,
             DistanceFunction distance = {});

  /// Velocity (lu) at any point of the array, zero inside the pillars. Bicubic Lagrange where all 16 nodes
  /// are fluid; next to a wall a moving least-squares fit of u = phi P2(x, y) with phi the wall distance
  /// and P2 a quadratic polynomial, which vanishes exactly on the true surface.
  Eigen::Vector2d velocity(double x, double y) const;

  /// Bilinear value with zero velocity on solid nodes: first order at walls, kept for comparison.
  Eigen::Vector2d velocity_bilinear(double x, double y) const;

  /// View for the streamline measurements, which are made on the gap line; refers to this object.
  PlaneFlow flow(const GapLine& gap, double tilt = 0) const;

  /// Velocities (lu) and solid flags on the nodes, nx x ny; node (0, 0) stands at (x0, y0).
  const Eigen::ArrayXXd& u() const { return u_; }
  const Eigen::ArrayXXd& v() const { return v_; }
  const SolidFlags& solid() const { return solid_; }
  double x0() const { return x0_; }
  double y0() const { return y0_; }

  int nx() const { return static_cast<int>(u_.rows()); }
  int ny() const { return static_cast<int>(u_.cols()); }
  int row_shift() const { return row_shift_; }

 private:
  /// Storage index of node (i, j) of the unbounded lattice.
  struct Node {
    int i, j;
  };
  Node wrap(int i, int j) const;
  Eigen::Vector2d bicubic(int i, int j, double s, double t) const;
  Eigen::Vector2d wall_fit(double x, double y) const;
  bool stencil_is_fluid(int i, int j) const;

  Eigen::ArrayXXd u_, v_, node_distance_;
  SolidFlags solid_;
  double x0_, y0_;
  int row_shift_;
  DistanceFunction distance_;
};

}  // namespace dld
