#pragma once
/// Static optical tweezer: two opposite forces stretch a cell along x; the shape at rest minimises
///   E(x) - F (mean x over the right patch - mean x over the left patch).
/// Any consistent units; with um and pN, 1 uN/m = 1 pN/um, 1 J = 1e18 pN um and energies are in pN um.
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "membrane/membrane.hpp"

namespace dld {

/// Vertices that are held by the beads at the two ends.
struct ContactPatches {
  std::vector<int> left, right;  ///< towards -x and +x

  /// Vertices closer than contact_radius to the tips of the shape, as a distance in space, so that no vertex
  /// of the dimple is caught. A tip is the mean of the vertices of least or largest x: (+-r, 0, 0) of a red
  /// cell. Throws std::invalid_argument when a patch is empty.
  ContactPatches(const Eigen::MatrixX3d& shape, double contact_radius);

  /// Adds the pull to nodal forces f (nv x 3): +force along x spread evenly over the right patch,
  /// -force over the left one.
  void add_pull(double force, Eigen::MatrixX3d& f) const;

  /// Mean x of the right patch minus mean x of the left one; its product with the force is the work.
  double separation(const Eigen::MatrixX3d& x) const;
};

/// Cell at rest under one force.
struct StretchedShape {
  Eigen::MatrixX3d vertices;  ///< nv x 3
  double axial = 0;           ///< extent along the pull, x
  double transverse = 0;      ///< extent across the pull in the plane of the cell, y
  double energy = 0;          ///< elastic energy of the membrane
  int iterations = 0;         ///< of the minimiser
  double residual = 0;        ///< largest unbalanced nodal force
  bool converged = false;     ///< residual below the tolerance
  bool stopped = false;       ///< by MinimiserOptions::stop
};

/// Accuracy of the minimiser.
struct MinimiserOptions {
  double force_tolerance = 1e-5;  ///< largest nodal force / (kS r), 4 pi r^2 the area; 1e-6 is in reach
  int max_iterations = 20000;
  std::function<bool()> stop = {};  ///< asked before every evaluation; true ends the search at once
};

/// Shape at rest under `force`, from the shape `start` (the reference or the last step of the ladder).
StretchedShape stretch(Membrane& membrane, const ContactPatches& patches, double force,
                       const Eigen::MatrixX3d& start, const MinimiserOptions& options = {});

/// Shapes at rest for a ladder of forces, each started from the one before.
std::vector<StretchedShape> stretch_ladder(Membrane& membrane, const ContactPatches& patches,
                                           const std::vector<double>& forces,
                                           const MinimiserOptions& options = {});

}  // namespace dld
