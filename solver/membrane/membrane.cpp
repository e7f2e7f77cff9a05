/// Reference state and connectivity of the membrane, its energy and what is measured on it. These run
/// once or on request; the forces of every time step are in membrane_forces.cpp.
#include "membrane/membrane.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "membrane/bending.hpp"
#include "membrane/constraints.hpp"
#include "membrane/skalak.hpp"

namespace dld {
namespace {

/// Corners of face f relative to the first vertex of the mesh: keeps the volume of a cell far from the
/// origin as precise as that of one at the origin.
struct FaceCorners {
  Vec3 x1, a, b, normal;
  FaceCorners(const Eigen::MatrixX3d& x, const Eigen::MatrixX3i& faces, Eigen::Index f) {
    const ConstColumns3 p(x);
    x1 = p[faces(f, 0)] - p[0];
    a = p[faces(f, 1)] - p[faces(f, 0)];
    b = p[faces(f, 2)] - p[faces(f, 0)];
    normal = cross(a, b);
  }
};

/// Place (0, 1, 2) of a vertex in a face that has it.
int corner_of(const Eigen::MatrixX3i& faces, int face, int vertex) {
  return faces(face, 0) == vertex ? 0 : (faces(face, 1) == vertex ? 1 : 2);
}

}  // namespace

Membrane::Membrane(TriangleMesh reference, const MembraneModuli& moduli, StressFreeAngle angle)
    : mesh_(std::move(reference)), moduli_(moduli), edges_(edges_of(mesh_)) {
  const auto nf = mesh_.faces.rows(), ne = static_cast<Eigen::Index>(edges_.size());
  metric_.resize(nf, 4);
  angle_.resize(ne, 2);
  edge_faces_.resize(ne, 3);
  face_edges_.resize(nf, 3);
  normal_.resize(nf, 3);
  sides_.resize(3 * nf, 3);
  hinge_.resize(ne);
  corner_force_.setZero(3 * nf + 1, 3);
  build_reference(angle);
  build_incidence();
}

void Membrane::build_reference(StressFreeAngle angle) {
  const MembraneState state = [&] {
    metric_.setOnes();
    return measure(mesh_.vertices);
  }();
  reference_area_ = state.area;
  reference_volume_ = state.volume;
  if (reference_volume_ <= 0) throw std::invalid_argument("membrane mesh is not oriented outward");
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const FaceCorners face(mesh_.vertices, mesh_.faces, f);
    const auto ref = reference_triangle(face.a, face.b);
    metric_.row(f) << ref.h11, ref.h12, ref.h22, ref.area;
  }
  const ConstColumns3 x(mesh_.vertices);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const Vec3 n = FaceCorners(mesh_.vertices, mesh_.faces, edge.face).normal;
    const Vec3 m = FaceCorners(mesh_.vertices, mesh_.faces, edge.opposite_face).normal;
    const auto [s, c] = scaled_dihedral(x[edge.v2] - x[edge.v1], n, m);
    const double length = std::hypot(s, c);
    const auto row = static_cast<Eigen::Index>(i);
    angle_.row(row) << (angle == StressFreeAngle::flat ? 0 : s / length),
        (angle == StressFreeAngle::flat ? 1 : c / length);
  }
}

void Membrane::build_incidence() {
  const auto nv = vertex_count(), nf = face_count();
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const int k3 = corner_of(mesh_.faces, edge.face, edge.v3);
    const int k4 = corner_of(mesh_.faces, edge.opposite_face, edge.v4);
    face_edges_(edge.face, k3) = face_edges_(edge.opposite_face, k4) = static_cast<int>(i);
    edge_faces_.row(static_cast<Eigen::Index>(i)) << k3 * static_cast<int>(nf) + edge.face, edge.face,
        edge.opposite_face;
  }
  Eigen::VectorXi valence = Eigen::VectorXi::Zero(nv);
  for (const Edge& edge : edges_) ++valence(edge.v1), ++valence(edge.v2);
  const int width = valence.maxCoeff();

  corners_.setConstant(nv, width, static_cast<int>(3 * nf));
  Eigen::VectorXi filled = Eigen::VectorXi::Zero(nv);
  for (int f = 0; f < nf; ++f) {
    for (int k = 0; k < 3; ++k) {
      const int v = mesh_.faces(f, k);
      corners_(v, filled(v)++) = static_cast<int>(k * nf) + f;
    }
  }
  neighbours_ = Eigen::VectorXi::LinSpaced(nv, 0, static_cast<int>(nv) - 1).replicate(1, width);
  filled.setZero();
  for (const Edge& edge : edges_) {
    neighbours_(edge.v1, filled(edge.v1)++) = edge.v2;
    neighbours_(edge.v2, filled(edge.v2)++) = edge.v1;
  }
}

double Membrane::volume(const Eigen::MatrixX3d& x) const {
  double sum = 0;
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const FaceCorners face(x, mesh_.faces, f);
    sum += face_volume(face.x1, face.normal);
  }
  return sum;
}

MembraneEnergy Membrane::energy_terms(const Eigen::MatrixX3d& x) const {
  const SkalakModuli skalak{moduli_.shear / moduli_.skalak_denominator, moduli_.local_area / 12};
  MembraneEnergy energy;
  double area = 0;
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const FaceCorners face(x, mesh_.faces, f);
    const ReferenceTriangle ref{metric_(f, 0), metric_(f, 1), metric_(f, 2), metric_(f, 3)};
    energy.skalak += skalak_energy(ref, skalak, face.a, face.b);
    area += face_area(face.normal);
  }
  const ConstColumns3 p(x);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const auto row = static_cast<Eigen::Index>(i);
    energy.bending += bending_energy(
        moduli_.bending, p[edge.v2] - p[edge.v1], FaceCorners(x, mesh_.faces, edge.face).normal,
        FaceCorners(x, mesh_.faces, edge.opposite_face).normal, {angle_(row, 0), angle_(row, 1)});
  }
  energy.area = penalty_energy(moduli_.global_area, area, reference_area_);
  energy.volume = penalty_energy(moduli_.volume, volume(x), reference_volume_);
  return energy;
}

MembraneState Membrane::measure(const Eigen::MatrixX3d& x) const {
  MembraneState state;
  state.volume = volume(x);
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const double area = face_area(FaceCorners(x, mesh_.faces, f).normal);
    const double ratio = area / metric_(f, 3);
    state.area += area;
    state.min_face_ratio = f == 0 ? ratio : std::min(state.min_face_ratio, ratio);
    state.max_local_area_strain = std::max(state.max_local_area_strain, std::abs(ratio - 1));
  }
  return state;
}

}  // namespace dld
