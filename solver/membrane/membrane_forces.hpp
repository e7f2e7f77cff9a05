#pragma once
/// Forces of a membrane and the gradient of its volume, in one pass: the work of every time step.
#include <Eigen/Core>
#include <vector>

#include "membrane/reference.hpp"
#include "membrane/rows.hpp"

namespace dld {

/// Whether a membrane is its own mirror image about the plane z = 0, in the reference shape and in every
/// shape that is asked for.
enum class MirrorSymmetry { none, about_z };

/// Positions, forces and gradients are nv x 3 and column-major: x, y and z are each contiguous. With mirror
/// symmetry only the vertices with z >= 0 (in the reference shape) are read and worked on, together with the
/// faces and edges that act on them; the other half of every result is filled in by reflection. No call
/// allocates memory once the arguments have their size, and results do not depend on the number of threads.
/// One object serves one thread.
class MembraneForces {
 public:
  /// Throws std::invalid_argument when the mesh does not have the symmetry.
  explicit MembraneForces(const MembraneReference& reference, MirrorSymmetry symmetry = MirrorSymmetry::none);

  /// Nodal forces f = -dE/dx at positions x; f is overwritten.
  AreaAndVolume forces(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& f);

  /// The same, and the gradient of the enclosed volume g = dV/dx, whose sum is zero.
  AreaAndVolume forces(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& f, Eigen::MatrixX3d& g);

  /// The gradient alone.
  AreaAndVolume volume_gradient(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& g);

 private:
  void choose_vertices(const TriangleMesh& mesh);
  void choose_faces(const MembraneReference& reference);
  void choose_edges(const MembraneReference& reference);
  void choose_curvatures(const MembraneReference& reference);
  void build_incidence();

  void load(const Eigen::MatrixX3d& x);
  AreaAndVolume update_faces();
  void update_edges();
  void update_curvatures();
  void update_corner_forces(AreaAndVolume now);
  void add_curvature_forces();
  void sum_at_vertices(const Rows& rows, const Eigen::MatrixXi& places, double scale,
                       Eigen::MatrixX3d& out) const;

  MembraneModuli moduli_;
  double reference_area_, reference_volume_;
  bool mirrored_;

  // Vertices are numbered anew: first the nw that are worked on, those above the plane leading, then the
  // images of these. Without symmetry all are worked on and there are no images.
  Eigen::VectorXi vertex_;    ///< nw: number in the mesh
  Eigen::VectorXi image_;     ///< (nv - nw): number in the mesh of the image of the first vertices
  Eigen::VectorXi renumber_;  ///< nv: from the mesh's numbers to the new ones

  // Faces: first the na that have a corner that is worked on, then those that only share an edge with these.
  std::vector<int> face_;        ///< nf: number in the mesh
  Eigen::MatrixX3i faces_;       ///< nf x 3: corners
  Eigen::Index acting_ = 0;      ///< na
  Eigen::ArrayXXd metric_;       ///< na x 4: as in MembraneReference
  Eigen::ArrayXd share_;         ///< nf: how often the face counts in area and volume
  Eigen::MatrixX3i face_edges_;  ///< na x 3: the edge opposite to each corner

  Eigen::Array<int, Eigen::Dynamic, 4>
      edges_;              ///< ne x 4: first and second end, their face, the opposite face
  Eigen::ArrayX2d angle_;  ///< ne x 2: as in MembraneReference

  Eigen::MatrixXi vertex_corners_;  ///< valence x nw: corners 3 face + k at a vertex; unused: the zero row
  Eigen::MatrixXi vertex_faces_;    ///< valence x nw: faces at a vertex; unused places: the zero row

  // Of the bending law mean_curvature alone; empty for the others.
  Eigen::ArrayX2d curvature_;     ///< nw x 2: as in MembraneReference
  Eigen::MatrixXi vertex_edges_;  ///< valence x nw: edges at a vertex; unused places: the last, zero one
  Eigen::ArrayXd edge_sum_;       ///< ne + 1: |e| theta; last one zero
  Eigen::ArrayXd pull_;           ///< ne: tension of an edge over its length, half of it (for either face)
  Eigen::ArrayX2d stress_;        ///< nv x 2: q of a vertex, and q times twice its mean curvature

  Rows position_;           ///< of vertices, relative to one of them
  Rows normal_;             ///< nf + 1: a x b, twice the area; last row zero
  Rows corner_force_;       ///< 3 na + 1: of face f on corner k in row 3 f + k; last row zero
  Eigen::MatrixX3d a_, b_;  ///< nf x 3: sides x2 - x1 and x3 - x1 of a face
  Eigen::ArrayXd hinge_;    ///< ne: bending moment per edge length
};

}  // namespace dld
