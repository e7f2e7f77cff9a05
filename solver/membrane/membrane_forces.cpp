/// The loops of every time step: faces -> edges -> faces -> vertices, each vectorised and in a fixed
/// order. What one face or edge does is in skalak.hpp, bending.hpp and constraints.hpp.
#include "membrane/membrane_forces.hpp"

#include <algorithm>

#include "membrane/bending.hpp"
#include "membrane/constraints.hpp"
#include "membrane/mean_curvature.hpp"
#include "membrane/skalak.hpp"

namespace dld {
namespace {

/// Calls work(begin, n) for consecutive pieces of 0 .. count - 1.
template <class Work>
void for_chunks(Eigen::Index count, Work&& work) {
  for (Eigen::Index begin = 0; begin < count; begin += chunk_size) {
    work(begin, static_cast<int>(std::min<Eigen::Index>(chunk_size, count - begin)));
  }
}

}  // namespace

AreaAndVolume MembraneForces::forces(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& f) {
  load(x);
  const AreaAndVolume now = update_faces();
  const bool curvatures = moduli_.bending_law == BendingLaw::mean_curvature;
  curvatures ? update_curvatures() : update_edges();
  update_corner_forces(now);
  if (curvatures) add_curvature_forces();
  sum_at_vertices(corner_force_, vertex_corners_, 1.0, f);
  return now;
}

AreaAndVolume MembraneForces::forces(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& f, Eigen::MatrixX3d& g) {
  const AreaAndVolume now = forces(x, f);
  sum_at_vertices(normal_, vertex_faces_, volume_gradient_per_normal, g);
  return now;
}

AreaAndVolume MembraneForces::volume_gradient(const Eigen::MatrixX3d& x, Eigen::MatrixX3d& g) {
  load(x);
  const AreaAndVolume now = update_faces();
  sum_at_vertices(normal_, vertex_faces_, volume_gradient_per_normal, g);
  return now;
}

/// Positions relative to the first vertex, which keeps the volume of a cell far from the origin as precise
/// as that of one at the origin; the mirror plane stays where it is.
void MembraneForces::load(const Eigen::MatrixX3d& positions) {
  const ConstColumns3 x(positions);
  const RowsOut out(position_);
  const Eigen::Index nw = vertex_.size(), images = image_.size();
  Vec3 origin = x[vertex_[0]];
  if (mirrored_) origin.z = 0;
  for (Eigen::Index i = 0; i < nw; ++i) out.set(i, x[vertex_[i]] - origin);
  for (Eigen::Index i = 0; i < images; ++i) {
    const Vec3 p = x[vertex_[i]] - origin;
    out.set(nw + i, {p.x, p.y, -p.z});
  }
}

AreaAndVolume MembraneForces::update_faces() {
  const Eigen::Index nf = faces_.rows();
  const int *v1 = faces_.data(), *v2 = v1 + nf, *v3 = v2 + nf;
  const double* share = share_.data();
  const RowsOut normal(normal_);
  const ConstRows m(normal_);
  const Columns3 side_a(a_), side_b(b_);
  RowChunk corners, sides2, sides3;
  const ConstRows x1(corners), a(sides2), b(sides3);
  AreaAndVolume sum;
  for_chunks(nf, [&](Eigen::Index begin, int n) {
    fetch_rows(position_, v1 + begin, n, corners);
    fetch_differences(position_, v1 + begin, v2 + begin, n, sides2);
    fetch_differences(position_, v1 + begin, v3 + begin, n, sides3);
#pragma omp simd
    for (int i = 0; i < n; ++i) {
      side_a.set(begin + i, a[i]);
      side_b.set(begin + i, b[i]);
      normal.set(begin + i, cross(a[i], b[i]));
    }
    double area = 0, volume = 0;
#pragma omp simd reduction(+ : area, volume)
    for (int i = 0; i < n; ++i) {
      area += share[begin + i] * face_area(m[begin + i]);
      volume += share[begin + i] * face_volume(x1[i], m[begin + i]);
    }
    sum.area += area;
    sum.volume += volume;
  });
  return sum;
}

void MembraneForces::update_edges() {
  const Eigen::Index ne = edges_.rows();
  const int *v1 = edges_.data(), *v2 = v1 + ne, *face = v2 + ne, *opposite = face + ne;
  const double *sine0 = angle_.data(), *cosine0 = sine0 + ne;
  const double stiffness = entry(moduli_.bending_law).hinge_prefactor * moduli_.bending;
  double* hinge = hinge_.data();
  RowChunk sides, normals1, normals2;
  const ConstRows e(sides), n1(normals1), n2(normals2);
  for_chunks(ne, [&](Eigen::Index begin, int n) {
    fetch_differences(position_, v1 + begin, v2 + begin, n, sides);
    fetch_rows(normal_, face + begin, n, normals1);
    fetch_rows(normal_, opposite + begin, n, normals2);
#pragma omp simd
    for (int i = 0; i < n; ++i) {
      hinge[begin + i] = hinge_moment(stiffness, e[i], n1[i], n2[i], {sine0[begin + i], cosine0[begin + i]});
    }
  });
}

/// Edges -> vertices -> edges: angles, mean curvatures and their stresses, moments and pulls.
void MembraneForces::update_curvatures() {
  const ConstRows x(position_), normal(normal_);
  const Eigen::Index ne = edges_.rows(), nw = vertex_.size(), images = image_.size();
  Eigen::ArrayXd& angle = hinge_;  // until the moments take its place
  for (Eigen::Index i = 0; i < ne; ++i) {
    const Vec3 e = x[edges_(i, 1)] - x[edges_(i, 0)];
    angle(i) = bending_angle(e, normal[edges_(i, 2)], normal[edges_(i, 3)], {0, 1});
    const double length = std::sqrt(dot(e, e));
    edge_sum_(i) = length * angle(i);
    pull_(i) = 0.5 * angle(i) / length;
  }
  for (Eigen::Index v = 0; v < nw; ++v) {
    double sum = 0, area = 0;
    for (int edge : vertex_edges_.col(v)) sum += edge_sum_(edge);
    for (int face : vertex_faces_.col(v)) area += face_area(normal[face]) / 3;
    const double m = twice_mean_curvature(sum, area);
    const double q = curvature_stress(moduli_.bending, m, curvature_(v, 0), area, curvature_(v, 1));
    stress_.row(v) << q, q * m;
  }
  stress_.bottomRows(images) = stress_.topRows(images);
  for (Eigen::Index i = 0; i < ne; ++i) {
    hinge_(i) = 0.5 * (stress_(edges_(i, 0), 0) + stress_(edges_(i, 1), 0));
    pull_(i) *= hinge_(i);
  }
}

/// What the mean curvature pulls within the surface, added to the forces on the corners.
void MembraneForces::add_curvature_forces() {
  const ConstRows normal(normal_);
  const ConstColumns3 side_a(a_), side_b(b_);
  const auto add = [this](Eigen::Index corner, Vec3 f) {
    corner_force_.col(corner) += Eigen::Vector4d(f.x, f.y, f.z, 0);
  };
  for (Eigen::Index i = 0; i < acting_; ++i) {
    const auto corner = faces_.row(i);
    const auto edge = face_edges_.row(i);
    const double tension = -(stress_(corner(0), 1) + stress_(corner(1), 1) + stress_(corner(2), 1)) / 3;
    const auto [f2, f3] = curvature_forces(side_a[i], side_b[i], normal[i], pull_(edge(0)), pull_(edge(1)),
                                           pull_(edge(2)), tension);
    add(3 * i, -1.0 * (f2 + f3));
    add(3 * i + 1, f2);
    add(3 * i + 2, f3);
  }
}

void MembraneForces::update_corner_forces(AreaAndVolume now) {
  const double tension = penalty_derivative(moduli_.global_area, now.area, reference_area_);
  const double pressure = -penalty_derivative(moduli_.volume, now.volume, reference_volume_);
  const SkalakModuli skalak{moduli_.shear / moduli_.skalak_denominator, moduli_.local_area / 12};
  const ConstRows normal(normal_);
  const ConstColumns3 side_a(a_), side_b(b_);
  const double *h11 = metric_.data(), *h12 = h11 + acting_, *h22 = h12 + acting_, *area0 = h22 + acting_;
  const int *e1 = face_edges_.data(), *e2 = e1 + acting_, *e3 = e2 + acting_;
  const double* hinge = hinge_.data();
  const RowsOut force(corner_force_);
  double m1[chunk_size], m2[chunk_size], m3[chunk_size];
  for_chunks(acting_, [&](Eigen::Index begin, int count) {
    for (int i = 0; i < count; ++i) {
      m1[i] = hinge[e1[begin + i]], m2[i] = hinge[e2[begin + i]], m3[i] = hinge[e3[begin + i]];
    }
    // A function of its own: values of class type declared inside a simd loop would stop its vectorisation.
    const auto update_face = [&](Eigen::Index i, int k) {
      const Vec3 a = side_a[i], b = side_b[i], n = normal[i];
      const auto in_plane = skalak_forces({h11[i], h12[i], h22[i], area0[i]}, skalak, tension, a, b);
      const auto bending = hinge_forces(a, b, n, m1[k], m2[k], m3[k]);
      const Vec3 f2 = in_plane.f2 + bending.f2, f3 = in_plane.f3 + bending.f3;
      const Vec3 push = (pressure * volume_gradient_per_normal) * n;
      force.set(3 * i, push - f2 - f3);
      force.set(3 * i + 1, push + f2);
      force.set(3 * i + 2, push + f3);
    };
#pragma omp simd
    for (int i = 0; i < count; ++i) update_face(begin + i, i);
  });
}

/// out = scale times the sum of the rows at each vertex, reflected to the images.
void MembraneForces::sum_at_vertices(const Rows& rows, const Eigen::MatrixXi& places, double scale,
                                     Eigen::MatrixX3d& out) const {
  const Eigen::Index nw = vertex_.size(), images = image_.size(), valence = places.rows();
  out.resize(nw + images, 3);
  const Columns3 result(out);
  const auto sum_at = [&](Eigen::Index i) {
    const int* place = places.data() + i * valence;
    Eigen::Vector4d sum = rows.col(place[0]);
    for (Eigen::Index k = 1; k < valence; ++k) sum += rows.col(place[k]);
    sum *= scale;
    return Vec3{sum[0], sum[1], sum[2]};
  };
  for (Eigen::Index i = 0; i < images; ++i) {
    const Vec3 sum = sum_at(i);
    result.set(vertex_[i], sum);
    result.set(image_[i], {sum.x, sum.y, -sum.z});
  }
  for (Eigen::Index i = images; i < nw; ++i) {
    const Vec3 sum = sum_at(i);
    result.set(vertex_[i], {sum.x, sum.y, mirrored_ ? 0.0 : sum.z});
  }
}

}  // namespace dld
