#pragma once
/// Hyperelastic closed membrane: Skalak in-plane elasticity, bending, area and volume penalties.
#include <Eigen/Core>
#include <vector>

#include "membrane/mesh.hpp"

namespace dld {

/// Moduli in one consistent system of units (lattice units, or um and pN).
struct MembraneModuli {
  double shear = 0;                ///< kS, force / length
  double skalak_denominator = 12;  ///< k in W = (kS/k)(I1^2 + 2 I1 - 2 I2) + (kalpha/12) I2^2
  double local_area = 0;           ///< kalpha, force / length
  double global_area = 0;          ///< kA in (kA/2)(A - A0)^2 / A0, force / length
  double volume = 0;               ///< kV in (kV/2)(V - V0)^2 / V0, force / length^2; 0 when projected
  double bending = 0;              ///< kB in sqrt(3) kB sum (theta - theta0)^2, energy
};

/// Angles between neighbouring faces at which the membrane does not bend back.
enum class StressFreeAngle { reference, flat };

/// What is measured on a deformed membrane.
struct MembraneState {
  double area = 0;                   ///< A, length^2
  double volume = 0;                 ///< V, length^3
  double min_face_ratio = 1;         ///< smallest A_face / A0_face
  double max_local_area_strain = 0;  ///< largest |A_face / A0_face - 1|
};

/// Energy of a configuration, term by term.
struct MembraneEnergy {
  double skalak = 0, bending = 0, area = 0, volume = 0;
  double total() const { return skalak + bending + area + volume; }
};

/// Membrane that is free of stress in its reference shape. Positions and forces are nv x 3 and
/// column-major: x, y and z are each contiguous. No call allocates memory once the arguments have
/// their size, and results do not depend on the number of threads. One object serves one thread.
class Membrane {
 public:
  explicit Membrane(TriangleMesh reference, const MembraneModuli& moduli,
                    StressFreeAngle angle = StressFreeAngle::reference);

  /// Nodal forces f = -dE/dx at positions x; f is overwritten.
  void forces(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& f);

  /// Gradient of the enclosed volume, dV/dx at positions x; g is overwritten. Its sum is zero.
  void volume_gradient(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& g);

  /// Enclosed volume at positions x.
  double volume(const Eigen::MatrixX3d& x) const;

  /// Elastic energy at positions x.
  double energy(const Eigen::MatrixX3d& x) const { return energy_terms(x).total(); }
  MembraneEnergy energy_terms(const Eigen::MatrixX3d& x) const;

  /// Area, volume and local area strain at positions x.
  MembraneState measure(const Eigen::MatrixX3d& x) const;

  const TriangleMesh& reference() const { return mesh_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const MembraneModuli& moduli() const { return moduli_; }
  double reference_area() const { return reference_area_; }
  double reference_volume() const { return reference_volume_; }
  Eigen::Index vertex_count() const { return mesh_.vertices.rows(); }
  Eigen::Index face_count() const { return mesh_.faces.rows(); }

  /// Neighbours of each vertex, nv x (largest valence); unused places hold the vertex itself.
  const Eigen::MatrixXi& neighbours() const { return neighbours_; }

 private:
  struct AreaAndVolume {
    double area, volume;
  };

  void build_reference(StressFreeAngle angle);
  void build_incidence();
  AreaAndVolume update_faces(const Eigen::MatrixX3d& x);
  void update_edges();
  void update_corner_forces(double tension, double pressure);
  void sum_corners(Eigen::MatrixX3d& f) const;

  TriangleMesh mesh_;
  MembraneModuli moduli_;
  std::vector<Edge> edges_;
  double reference_area_ = 0, reference_volume_ = 0;

  Eigen::ArrayXXd metric_;       ///< nf x 4: inverse reference metric h11, h12, h22 and area A0
  Eigen::ArrayX2d angle_;        ///< ne x 2: sin and cos of the stress-free angle
  Eigen::ArrayX3i edge_faces_;   ///< ne x 3: corner opposite to the edge (k nf + face), its two faces
  Eigen::MatrixX3i face_edges_;  ///< nf x 3: the edge opposite to each corner
  Eigen::MatrixXi corners_;      ///< nv x valence: corners at a vertex; unused places: the zero row
  Eigen::MatrixXi neighbours_;   ///< nv x valence

  Eigen::MatrixX3d normal_;        ///< nf x 3: a x b, twice the area
  Eigen::MatrixX3d sides_;         ///< 3 nf x 3: row k nf + f is the side of face f opposite to corner k
  Eigen::ArrayXd hinge_;           ///< ne: bending moment per edge length
  Eigen::MatrixX3d corner_force_;  ///< (3 nf + 1) x 3: force of face f on corner k; last row zero
};

}  // namespace dld
