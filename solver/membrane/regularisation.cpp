#include "membrane/regularisation.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/rows.hpp"

namespace dld {

void tangential_relaxation(const Membrane& membrane, const Eigen::MatrixX3d& f,
                           const Eigen::MatrixX3d& volume_gradient, double mobility,
                           Eigen::MatrixX3d& v_add) {
  const Eigen::MatrixXi& neighbours = membrane.neighbours();
  const Eigen::Index nv = membrane.vertex_count(), valence = neighbours.rows();
  const ConstColumns3 force(f), direction(volume_gradient);
  const auto tangential = [&](Eigen::Index v, Vec3 a) {
    const Vec3 n = direction[v];
    return a - (dot(a, n) / dot(n, n)) * n;
  };
  Rows rows(4, nv);
  const RowsOut row(rows);
  for (Eigen::Index v = 0; v < nv; ++v) row.set(v, tangential(v, force[v]));
  const double weight = mobility / 6;
  Rows velocity(4, nv);
  const RowsOut out(velocity);
  Vec3 total{0, 0, 0};
  for (Eigen::Index v = 0; v < nv; ++v) {
    // A vertex of lower valence is its own neighbour in the unused places, which adds nothing.
    const int* neighbour = neighbours.data() + v * valence;
    const Eigen::Vector4d own = rows.col(v);
    Eigen::Vector4d difference = own - rows.col(neighbour[0]);
    for (Eigen::Index k = 1; k < valence; ++k) difference += own - rows.col(neighbour[k]);
    const Vec3 moved = weight * tangential(v, {difference[0], difference[1], difference[2]});
    out.set(v, moved);
    total = total + moved;
  }
  const Eigen::Vector3d mean = Eigen::Vector3d(total.x, total.y, total.z) / static_cast<double>(nv);
  v_add += (velocity.topRows<3>().colwise() - mean).transpose();
}

double largest_tangential_stiffness(Membrane& membrane) {
  constexpr int iterations = 60;
  const Eigen::MatrixX3d& x = membrane.reference().vertices;
  Eigen::MatrixX3d normal(x.rows(), 3);
  membrane.volume_gradient(x, normal);
  normal.rowwise().normalize();
  const double step =
      1e-6 * std::sqrt(membrane.reference_area() / static_cast<double>(membrane.face_count()));
  // A start without symmetry, so that it has a share in every mode.
  Eigen::MatrixX3d mode(x.rows(), 3), forward(x.rows(), 3), backward(x.rows(), 3);
  for (Eigen::Index i = 0; i < mode.size(); ++i) mode(i) = std::sin(1.0 + 12.9898 * static_cast<double>(i));
  mode -= normal_part(mode, normal);
  double stiffness = 0.0;
  for (int k = 0; k < iterations; ++k) {
    mode *= 1.0 / mode.rowwise().norm().maxCoeff();
    membrane.forces(x + step * mode, forward);
    membrane.forces(x - step * mode, backward);
    Eigen::MatrixX3d response = (backward - forward) / (2.0 * step);
    response -= normal_part(response, normal);
    stiffness = response.norm() / mode.norm();
    mode = response;
  }
  return stiffness;
}

double stable_mobility(Membrane& membrane, double wanted) {
  constexpr double share = 0.6;
  if (wanted <= 0.0) return 0.0;
  return std::min(wanted, share * 2.0 / (1.5 * largest_tangential_stiffness(membrane)));
}

}  // namespace dld
