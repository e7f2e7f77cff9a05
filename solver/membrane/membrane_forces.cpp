/// The loops of every time step: faces -> edges -> faces -> vertices, each vectorised and in a fixed
/// order. What one face or edge does is in skalak.hpp, bending.hpp and constraints.hpp.
#include "membrane/bending.hpp"
#include "membrane/constraints.hpp"
#include "membrane/membrane.hpp"
#include "membrane/skalak.hpp"

namespace dld {

void Membrane::forces(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& f) {
  const auto [area, volume] = update_faces(x);
  update_edges();
  const double tension = penalty_derivative(moduli_.global_area, area, reference_area_);
  const double pressure = -penalty_derivative(moduli_.volume, volume, reference_volume_);
  update_corner_forces(tension, pressure);
  sum_corners(f);
}

void Membrane::volume_gradient(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& g) {
  update_faces(x);
  const ConstColumns3 normal(normal_);
  const Columns3 gradient(corner_force_);
  const Eigen::Index nf = face_count();
#pragma omp simd
  for (Eigen::Index i = 0; i < nf; ++i) {
    gradient.set(i, volume_gradient_of_face(normal[i]));
    gradient.set(i + nf, volume_gradient_of_face(normal[i]));
    gradient.set(i + 2 * nf, volume_gradient_of_face(normal[i]));
  }
  sum_corners(g);
}

Membrane::AreaAndVolume Membrane::update_faces(const Eigen::MatrixX3d& positions) {
  const ConstColumns3 x(positions);
  const Columns3 normal(normal_), side(sides_);
  const Eigen::Index nf = face_count();
  const int *v1 = mesh_.faces.data(), *v2 = v1 + nf, *v3 = v2 + nf;
  const Vec3 origin = x[0];
  double area = 0, volume = 0;
#pragma omp simd reduction(+ : area, volume)
  for (Eigen::Index i = 0; i < nf; ++i) {
    const Vec3 x1 = x[v1[i]];
    const Vec3 a = x[v2[i]] - x1, b = x[v3[i]] - x1, n = cross(a, b);
    side.set(i, b - a);
    side.set(i + nf, -1.0 * b);
    side.set(i + 2 * nf, a);
    normal.set(i, n);
    area += face_area(n);
    volume += face_volume(x1 - origin, n);
  }
  return {area, volume};
}

void Membrane::update_edges() {
  const ConstColumns3 normal(normal_), side(sides_);
  const Eigen::Index ne = edge_faces_.rows();
  const int *opposite = edge_faces_.data(), *face1 = opposite + ne, *face2 = face1 + ne;
  const double *sine0 = angle_.data(), *cosine0 = sine0 + ne;
  double* hinge = hinge_.data();
#pragma omp simd
  for (Eigen::Index i = 0; i < ne; ++i) {
    hinge[i] = hinge_moment(moduli_.bending, side[opposite[i]], normal[face1[i]], normal[face2[i]],
                            {sine0[i], cosine0[i]});
  }
}

void Membrane::update_corner_forces(double tension, double pressure) {
  const SkalakModuli skalak{moduli_.shear / moduli_.skalak_denominator, moduli_.local_area / 12};
  const Eigen::Index nf = face_count();
  const ConstColumns3 normal(normal_), side(sides_);
  const double *h11 = metric_.data(), *h12 = h11 + nf, *h22 = h12 + nf, *area0 = h22 + nf;
  const int *e1 = face_edges_.data(), *e2 = e1 + nf, *e3 = e2 + nf;
  const double* hinge = hinge_.data();
  const Columns3 force(corner_force_);
  // A function of its own: values of class type declared inside a simd loop would stop its vectorisation.
  const auto update_face = [&](Eigen::Index i) {
    const Vec3 a = side[i + 2 * nf], b = -1.0 * side[i + nf], n = normal[i];
    const auto in_plane = skalak_forces({h11[i], h12[i], h22[i], area0[i]}, skalak, tension, a, b);
    const auto bending = hinge_forces(a, b, n, hinge[e1[i]], hinge[e2[i]], hinge[e3[i]]);
    const Vec3 f2 = in_plane.f2 + bending.f2, f3 = in_plane.f3 + bending.f3;
    const Vec3 push = pressure * volume_gradient_of_face(n);
    force.set(i, push - f2 - f3);
    force.set(i + nf, push + f2);
    force.set(i + 2 * nf, push + f3);
  };
#pragma omp simd
  for (Eigen::Index i = 0; i < nf; ++i) update_face(i);
}

void Membrane::sum_corners(Eigen::MatrixX3d& f) const {
  const ConstColumns3 corner(corner_force_);
  const Eigen::Index nv = vertex_count();
  f.resize(nv, 3);
  const Columns3 out(f);
  const ConstColumns3 sum(f);
  f.setZero();
  for (Eigen::Index slot = 0; slot < corners_.cols(); ++slot) {
    const int* c = corners_.data() + slot * nv;
#pragma omp simd
    for (Eigen::Index v = 0; v < nv; ++v) out.set(v, sum[v] + corner[c[v]]);
  }
}

}  // namespace dld
