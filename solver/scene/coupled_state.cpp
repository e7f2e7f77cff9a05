#include "scene/coupled_state.hpp"

#include "output/provenance.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/reader.hpp"

namespace dld {

std::vector<double> to_values(const Eigen::MatrixX3d& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}

Eigen::MatrixX3d to_matrix(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::MatrixX3d>(values.data(), static_cast<Eigen::Index>(values.size()) / 3, 3);
}

std::string checkpoint_identity(const Case& c) {
  // A mesh file may change while its name stays.
  const std::string surface = c.cell.surface ? fingerprint(cell_mesh(c.cell, 1.0)) : "";
  return echo(c).dump() + surface + build_fingerprint();
}

}  // namespace dld
