/// Which vertices, faces and edges take part in the forces of a step, and how they meet.
#include <algorithm>

#include "membrane/membrane_forces.hpp"

namespace dld {
namespace {

/// Place (0, 1, 2) of a vertex in a face that has it.
int corner_of(const Eigen::MatrixX3i& faces, int face, int vertex) {
  return faces(face, 0) == vertex ? 0 : (faces(face, 1) == vertex ? 1 : 2);
}

}  // namespace

MembraneForces::MembraneForces(const MembraneReference& reference, MirrorSymmetry symmetry)
    : moduli_(reference.moduli),
      reference_area_(reference.area),
      reference_volume_(reference.volume),
      mirrored_(symmetry == MirrorSymmetry::about_z) {
  choose_vertices(reference.mesh);
  choose_faces(reference);
  choose_edges(reference);
  build_incidence();
  if (moduli_.bending_law == BendingLaw::mean_curvature) choose_curvatures(reference);
  const auto nf = faces_.rows();
  position_.setZero(4, renumber_.size());
  normal_.setZero(4, nf + 1);
  corner_force_.setZero(4, 3 * acting_ + 1);
  a_.resize(nf, 3);
  b_.resize(nf, 3);
  hinge_.resize(edges_.rows());
}

void MembraneForces::choose_vertices(const TriangleMesh& mesh) {
  const int nv = static_cast<int>(mesh.vertices.rows());
  std::vector<int> order, images;
  if (mirrored_) {
    const Eigen::VectorXi image_of = mirror_images(mesh.vertices);
    std::vector<int> on_plane;
    for (int v = 0; v < nv; ++v) {
      if (image_of(v) == v) on_plane.push_back(v);
      if (mesh.vertices(v, 2) <= 0) continue;
      order.push_back(v);
      images.push_back(image_of(v));
    }
    order.insert(order.end(), on_plane.begin(), on_plane.end());
  } else {
    for (int v = 0; v < nv; ++v) order.push_back(v);
  }
  vertex_ = Eigen::Map<Eigen::VectorXi>(order.data(), static_cast<Eigen::Index>(order.size()));
  image_ = Eigen::Map<Eigen::VectorXi>(images.data(), static_cast<Eigen::Index>(images.size()));
  renumber_.resize(nv);
  int next = 0;
  for (int v : vertex_) renumber_(v) = next++;
  for (int v : image_) renumber_(v) = next++;
}

void MembraneForces::choose_faces(const MembraneReference& reference) {
  const Eigen::MatrixX3i& faces = reference.mesh.faces;
  const int worked_on = static_cast<int>(vertex_.size()),
            above = mirrored_ ? static_cast<int>(image_.size()) : worked_on;
  enum Role : char { none, borders, acts };
  std::vector<Role> role(static_cast<std::size_t>(faces.rows()), none);
  const auto role_of = [&](int f) -> Role& { return role[static_cast<std::size_t>(f)]; };
  for (int f = 0; f < faces.rows(); ++f) {
    for (int v : faces.row(f)) {
      if (renumber_(v) < worked_on) role_of(f) = acts;
    }
  }
  for (const Edge& edge : reference.edges) {
    if (role_of(edge.face) == acts)
      role_of(edge.opposite_face) = std::max(role_of(edge.opposite_face), borders);
    if (role_of(edge.opposite_face) == acts) role_of(edge.face) = std::max(role_of(edge.face), borders);
  }
  for (const Role wanted : {acts, borders}) {
    for (int f = 0; f < faces.rows(); ++f) {
      if (role_of(f) == wanted) face_.push_back(f);
    }
    if (wanted == acts) acting_ = static_cast<Eigen::Index>(face_.size());
  }
  const auto nf = static_cast<Eigen::Index>(face_.size());
  faces_.resize(nf, 3);
  share_.setZero(nf);
  metric_.resize(acting_, 4);
  for (Eigen::Index i = 0; i < nf; ++i) {
    for (int k = 0; k < 3; ++k) faces_(i, k) = renumber_(faces(face_[static_cast<std::size_t>(i)], k));
    if (i >= acting_) continue;
    metric_.row(i) = reference.metric.row(face_[static_cast<std::size_t>(i)]);
    // The image of a face that is wholly above the plane is not in the list: the face counts for both.
    share_(i) = mirrored_ && faces_.row(i).maxCoeff() < above ? 2 : 1;
  }
}

void MembraneForces::choose_edges(const MembraneReference& reference) {
  const int nf = static_cast<int>(face_.size());
  std::vector<int> place(static_cast<std::size_t>(reference.mesh.faces.rows()), nf);  // of a face in faces_
  for (int i = 0; i < nf; ++i) place[static_cast<std::size_t>(face_[static_cast<std::size_t>(i)])] = i;
  std::vector<Eigen::Index> chosen;
  const auto place_of = [&](int f) { return place[static_cast<std::size_t>(f)]; };
  for (std::size_t i = 0; i < reference.edges.size(); ++i) {
    const Edge& edge = reference.edges[i];
    if (std::min(place_of(edge.face), place_of(edge.opposite_face)) < acting_)
      chosen.push_back(static_cast<Eigen::Index>(i));
  }
  edges_.resize(static_cast<Eigen::Index>(chosen.size()), 4);
  angle_ = reference.angle(chosen, Eigen::all);
  face_edges_.resize(acting_, 3);
  for (Eigen::Index i = 0; i < edges_.rows(); ++i) {
    const Edge& edge = reference.edges[static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)])];
    edges_.row(i) << renumber_(edge.v1), renumber_(edge.v2), place_of(edge.face),
        place_of(edge.opposite_face);
    for (const auto& [face, vertex] : {std::pair{edge.face, edge.v3}, {edge.opposite_face, edge.v4}}) {
      if (place_of(face) < acting_)
        face_edges_(place_of(face), corner_of(reference.mesh.faces, face, vertex)) = static_cast<int>(i);
    }
  }
}

void MembraneForces::choose_curvatures(const MembraneReference& reference) {
  const int ne = static_cast<int>(edges_.rows()), worked_on = static_cast<int>(vertex_.size());
  curvature_ = reference.curvature(vertex_, Eigen::all);
  edge_sum_.setZero(ne + 1);
  pull_.setZero(ne);
  stress_.setZero(renumber_.size(), 2);
  vertex_edges_.setConstant(vertex_faces_.rows(), worked_on, ne);
  Eigen::VectorXi used = Eigen::VectorXi::Zero(worked_on);
  for (int i = 0; i < ne; ++i) {
    for (int v : {edges_(i, 0), edges_(i, 1)}) {
      if (v < worked_on) vertex_edges_(used(v)++, v) = i;
    }
  }
}

void MembraneForces::build_incidence() {
  const int worked_on = static_cast<int>(vertex_.size()), acting = static_cast<int>(acting_);
  std::vector<std::vector<int>> corners(static_cast<std::size_t>(worked_on));
  for (int f = 0; f < acting; ++f) {
    for (int k = 0; k < 3; ++k) {
      if (faces_(f, k) < worked_on) corners[static_cast<std::size_t>(faces_(f, k))].push_back(3 * f + k);
    }
  }
  std::size_t valence = 0;
  for (const auto& list : corners) valence = std::max(valence, list.size());
  vertex_corners_.setConstant(static_cast<Eigen::Index>(valence), worked_on, 3 * acting);
  vertex_faces_.setConstant(static_cast<Eigen::Index>(valence), worked_on, static_cast<int>(faces_.rows()));
  for (int v = 0; v < worked_on; ++v) {
    int slot = 0;
    for (int corner : corners[static_cast<std::size_t>(v)]) {
      vertex_corners_(slot, v) = corner;
      vertex_faces_(slot++, v) = corner / 3;
    }
  }
}

}  // namespace dld
