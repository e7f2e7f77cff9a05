#pragma once
/// Hyperelastic closed membrane: Skalak in-plane elasticity, bending, area and volume penalties.
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "membrane/membrane_forces.hpp"
#include "membrane/reference.hpp"

namespace dld {

/// Angles between neighbouring faces at which the membrane does not bend back.
enum class StressFreeAngle { reference, flat };

/// What is measured on a deformed membrane.
struct MembraneState {
  double area = 0;                   ///< A, length^2
  double volume = 0;                 ///< V, length^3
  double min_face_ratio = 1;         ///< smallest A_face / A0_face
  double max_local_area_strain = 0;  ///< largest |A_face / A0_face - 1|
};

/// Strain and tension of every face (nf).
struct FaceFields {
  Eigen::ArrayXd area_strain;    ///< A_face / A0_face - 1
  Eigen::ArrayXd mean_tension;   ///< (t1 + t2) / 2, force / length
  Eigen::ArrayXd shear_tension;  ///< |t1 - t2| / 2, force / length
};

/// Energy of a configuration, term by term.
struct MembraneEnergy {
  double skalak = 0, bending = 0, area = 0, volume = 0;
  double total() const { return skalak + bending + area + volume; }
};

/// Membrane that is free of stress in its reference shape. Positions and forces are nv x 3; see
/// MembraneForces for their storage. One object serves one thread.
class Membrane {
 public:
  explicit Membrane(TriangleMesh reference, const MembraneModuli& moduli,
                    StressFreeAngle angle = StressFreeAngle::reference);

  /// Nodal forces f = -dE/dx at positions x; f is overwritten.
  void forces(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& f) { whole_->forces(x, f); }

  /// Gradient of the enclosed volume, dV/dx at positions x; g is overwritten. Its sum is zero.
  void volume_gradient(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& g) { whole_->volume_gradient(x, g); }

  /// What computes forces step by step, for shapes that have the given symmetry; independent of this object.
  MembraneForces step_forces(MirrorSymmetry symmetry) const { return MembraneForces(reference_, symmetry); }

  /// Enclosed volume at positions x.
  double volume(const Eigen::MatrixX3d& x) const;

  /// Elastic energy at positions x.
  double energy(const Eigen::MatrixX3d& x) const { return energy_terms(x).total(); }
  MembraneEnergy energy_terms(const Eigen::MatrixX3d& x) const;

  /// Area, volume and local area strain at positions x.
  MembraneState measure(const Eigen::MatrixX3d& x) const;

  /// Strain and in-plane tension of each face at positions x; the tension is that of Skalak's law and of the
  /// penalty on the whole area, without bending.
  FaceFields face_fields(const Eigen::MatrixX3d& x) const;

  const TriangleMesh& reference() const { return reference_.mesh; }
  const std::vector<Edge>& edges() const { return reference_.edges; }
  const MembraneModuli& moduli() const { return reference_.moduli; }
  double reference_area() const { return reference_.area; }
  double reference_volume() const { return reference_.volume; }
  Eigen::Index vertex_count() const { return reference_.mesh.vertices.rows(); }
  Eigen::Index face_count() const { return reference_.mesh.faces.rows(); }

  /// Neighbours of each vertex, (largest valence) x nv; unused places hold the vertex itself.
  const Eigen::MatrixXi& neighbours() const { return neighbours_; }

 private:
  void build_reference(StressFreeAngle angle);
  Eigen::ArrayX2d node_curvatures(const Eigen::MatrixX3d& x) const;
  double bending_energy(const Eigen::MatrixX3d& x) const;
  void build_neighbours();

  MembraneReference reference_;
  Eigen::MatrixXi neighbours_;           ///< valence x nv
  std::optional<MembraneForces> whole_;  ///< without symmetry
};

}  // namespace dld
