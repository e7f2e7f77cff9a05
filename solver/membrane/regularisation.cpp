#include "membrane/regularisation.hpp"

#include "membrane/vec3.hpp"

namespace dld {

void force_difference_velocity(const Membrane& membrane, const Eigen::MatrixX3d& f, double mobility,
                               Eigen::MatrixX3d& v_add) {
  const Eigen::MatrixXi& neighbours = membrane.neighbours();
  const ConstColumns3 force(f), sum(v_add);
  const Columns3 velocity(v_add);
  const Eigen::Index nv = membrane.vertex_count();
  const double weight = mobility / 6;
  for (Eigen::Index slot = 0; slot < neighbours.cols(); ++slot) {
    const int* neighbour = neighbours.data() + slot * nv;
#pragma omp simd
    for (Eigen::Index v = 0; v < nv; ++v) {
      // A vertex of lower valence is its own neighbour in the unused places, which adds nothing.
      velocity.set(v, sum[v] + weight * (force[v] - force[neighbour[v]]));
    }
  }
}

}  // namespace dld
