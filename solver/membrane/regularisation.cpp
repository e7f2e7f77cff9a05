#include "membrane/regularisation.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/rows.hpp"

namespace dld {

void force_difference_velocity(const Membrane& membrane, const Eigen::MatrixX3d& f, double mobility,
                               Eigen::MatrixX3d& v_add) {
  const Eigen::MatrixXi& neighbours = membrane.neighbours();
  const Eigen::Index nv = membrane.vertex_count(), valence = neighbours.rows();
  Rows rows(4, nv);
  const ConstColumns3 force(f);
  const RowsOut row(rows);
  for (Eigen::Index v = 0; v < nv; ++v) row.set(v, force[v]);
  const double weight = mobility / 6;
  const ConstColumns3 sum(v_add);
  const Columns3 velocity(v_add);
  for (Eigen::Index v = 0; v < nv; ++v) {
    // A vertex of lower valence is its own neighbour in the unused places, which adds nothing.
    const int* neighbour = neighbours.data() + v * valence;
    const Eigen::Vector4d own = rows.col(v);
    Eigen::Vector4d difference = own - rows.col(neighbour[0]);
    for (Eigen::Index k = 1; k < valence; ++k) difference += own - rows.col(neighbour[k]);
    velocity.set(v, sum[v] + weight * Vec3{difference[0], difference[1], difference[2]});
  }
}

double largest_stiffness(Membrane& membrane) {
  constexpr int iterations = 60;
  const Eigen::MatrixX3d& x = membrane.reference().vertices;
  const double step =
      1e-6 * std::sqrt(membrane.reference_area() / static_cast<double>(membrane.face_count()));
  // A start without symmetry, so that it has a share in every mode.
  Eigen::MatrixX3d mode(x.rows(), 3), forward(x.rows(), 3), backward(x.rows(), 3);
  for (Eigen::Index i = 0; i < mode.size(); ++i) mode(i) = std::sin(1.0 + 12.9898 * static_cast<double>(i));
  double stiffness = 0.0;
  for (int k = 0; k < iterations; ++k) {
    mode *= 1.0 / mode.rowwise().norm().maxCoeff();
    membrane.forces(x + step * mode, forward);
    membrane.forces(x - step * mode, backward);
    const Eigen::MatrixX3d response = (backward - forward) / (2.0 * step);
    stiffness = response.norm() / mode.norm();
    mode = response;
  }
  return stiffness;
}

double stable_mobility(Membrane& membrane, double wanted) {
  constexpr double share = 0.25;
  if (wanted <= 0.0) return 0.0;
  return std::min(wanted, share * 2.0 / (1.5 * largest_stiffness(membrane)));
}

}  // namespace dld
