/// Reference state and connectivity of the membrane, its energy and what is measured on it. These run
/// once or on request; the forces of every time step are those of MembraneForces.
#include "membrane/membrane.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "membrane/bending.hpp"
#include "membrane/constraints.hpp"
#include "membrane/mean_curvature.hpp"
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

}  // namespace

Membrane::Membrane(TriangleMesh reference, const MembraneModuli& moduli, StressFreeAngle angle)
    : reference_{std::move(reference), moduli, {}, 0, 0, {}, {}, {}} {
  build_reference(angle);
  build_neighbours();
  whole_.emplace(reference_);
}

void Membrane::build_reference(StressFreeAngle angle) {
  auto& [mesh, moduli, edges, area, volume, metric, angles, curvature] = reference_;
  edges = edges_of(mesh);
  metric.setOnes(face_count(), 4);
  angles.resize(static_cast<Eigen::Index>(edges.size()), 2);
  const MembraneState state = measure(mesh.vertices);
  area = state.area;
  volume = state.volume;
  if (volume <= 0) throw std::invalid_argument("membrane mesh is not oriented outward");
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const FaceCorners face(mesh.vertices, mesh.faces, f);
    const auto ref = reference_triangle(face.a, face.b);
    metric.row(f) << ref.h11, ref.h12, ref.h22, ref.area;
  }
  const ConstColumns3 x(mesh.vertices);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& edge = edges[i];
    const Vec3 n = FaceCorners(mesh.vertices, mesh.faces, edge.face).normal;
    const Vec3 m = FaceCorners(mesh.vertices, mesh.faces, edge.opposite_face).normal;
    const auto [s, c] = scaled_dihedral(x[edge.v2] - x[edge.v1], n, m);
    const double length = std::hypot(s, c);
    const auto row = static_cast<Eigen::Index>(i);
    angles.row(row) << (angle == StressFreeAngle::flat ? 0 : s / length),
        (angle == StressFreeAngle::flat ? 1 : c / length);
  }
  curvature = node_curvatures(mesh.vertices);
  if (angle == StressFreeAngle::flat) curvature.col(0) = 0;
}

/// Twice the mean curvature, and area, of every node (nv x 2).
Eigen::ArrayX2d Membrane::node_curvatures(const Eigen::MatrixX3d& x) const {
  const auto& faces = reference_.mesh.faces;
  Eigen::ArrayX2d sums = Eigen::ArrayX2d::Zero(vertex_count(), 2);  // of |e| theta, and of area
  const ConstColumns3 p(x);
  for (const Edge& edge : edges()) {
    const Vec3 e = p[edge.v2] - p[edge.v1];
    const double angle = bending_angle(e, FaceCorners(x, faces, edge.face).normal,
                                       FaceCorners(x, faces, edge.opposite_face).normal, {0, 1});
    for (int v : {edge.v1, edge.v2}) sums(v, 0) += std::sqrt(dot(e, e)) * angle;
  }
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    for (int v : faces.row(f)) sums(v, 1) += face_area(FaceCorners(x, faces, f).normal) / 3;
  }
  for (auto node : sums.rowwise()) node(0) = twice_mean_curvature(node(0), node(1));
  return sums;
}

double Membrane::bending_energy(const Eigen::MatrixX3d& x) const {
  const BendingLaw law = reference_.moduli.bending_law;
  const double modulus = reference_.moduli.bending;
  double energy = 0;
  if (law == BendingLaw::mean_curvature) {
    const Eigen::ArrayX2d now = node_curvatures(x), &rest = reference_.curvature;
    for (Eigen::Index v = 0; v < vertex_count(); ++v)
      energy += mean_curvature_energy(modulus, now(v, 0), rest(v, 0), rest(v, 1));
    return energy;
  }
  const ConstColumns3 p(x);
  for (std::size_t i = 0; i < edges().size(); ++i) {
    const Edge& edge = edges()[i];
    const auto row = static_cast<Eigen::Index>(i);
    energy += hinge_energy(entry(law).hinge_prefactor * modulus, p[edge.v2] - p[edge.v1],
                           FaceCorners(x, reference_.mesh.faces, edge.face).normal,
                           FaceCorners(x, reference_.mesh.faces, edge.opposite_face).normal,
                           {reference_.angle(row, 0), reference_.angle(row, 1)});
  }
  return energy;
}

void Membrane::build_neighbours() {
  const auto nv = vertex_count();
  Eigen::VectorXi valence = Eigen::VectorXi::Zero(nv);
  for (const Edge& edge : edges()) ++valence(edge.v1), ++valence(edge.v2);
  neighbours_ =
      Eigen::RowVectorXi::LinSpaced(nv, 0, static_cast<int>(nv) - 1).replicate(valence.maxCoeff(), 1);
  valence.setZero();
  for (const Edge& edge : edges()) {
    neighbours_(valence(edge.v1)++, edge.v1) = edge.v2;
    neighbours_(valence(edge.v2)++, edge.v2) = edge.v1;
  }
}

double Membrane::volume(const Eigen::MatrixX3d& x) const {
  double sum = 0;
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const FaceCorners face(x, reference_.mesh.faces, f);
    sum += face_volume(face.x1, face.normal);
  }
  return sum;
}

MembraneEnergy Membrane::energy_terms(const Eigen::MatrixX3d& x) const {
  const SkalakModuli skalak{reference_.moduli.shear / reference_.moduli.skalak_denominator,
                            reference_.moduli.local_area / 12};
  MembraneEnergy energy;
  double area = 0;
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const FaceCorners face(x, reference_.mesh.faces, f);
    const ReferenceTriangle ref{reference_.metric(f, 0), reference_.metric(f, 1), reference_.metric(f, 2),
                                reference_.metric(f, 3)};
    energy.skalak += skalak_energy(ref, skalak, face.a, face.b);
    area += face_area(face.normal);
  }
  energy.bending = bending_energy(x);
  energy.area = penalty_energy(reference_.moduli.global_area, area, reference_.area);
  energy.volume = penalty_energy(reference_.moduli.volume, volume(x), reference_.volume);
  return energy;
}

FaceFields Membrane::face_fields(const Eigen::MatrixX3d& x) const {
  const MembraneModuli& moduli = reference_.moduli;
  const SkalakModuli skalak{moduli.shear / moduli.skalak_denominator, moduli.local_area / 12};
  const double tension = penalty_derivative(moduli.global_area, measure(x).area, reference_.area);
  FaceFields fields{Eigen::ArrayXd(face_count()), Eigen::ArrayXd(face_count()), Eigen::ArrayXd(face_count())};
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const FaceCorners face(x, reference_.mesh.faces, f);
    const auto metric = reference_.metric.row(f);
    const ReferenceTriangle ref{metric(0), metric(1), metric(2), metric(3)};
    fields.area_strain(f) = face_area(face.normal) / ref.area - 1;
    const FaceTensions tensions = skalak_tensions(ref, skalak, tension, face.a, face.b);
    fields.mean_tension(f) = tensions.mean;
    fields.shear_tension(f) = tensions.shear;
  }
  return fields;
}

MembraneState Membrane::measure(const Eigen::MatrixX3d& x) const {
  MembraneState state;
  state.volume = volume(x);
  for (Eigen::Index f = 0; f < face_count(); ++f) {
    const double area = face_area(FaceCorners(x, reference_.mesh.faces, f).normal);
    const double ratio = area / reference_.metric(f, 3);
    state.area += area;
    state.min_face_ratio = f == 0 ? ratio : std::min(state.min_face_ratio, ratio);
    state.max_local_area_strain = std::max(state.max_local_area_strain, std::abs(ratio - 1));
  }
  return state;
}

}  // namespace dld
