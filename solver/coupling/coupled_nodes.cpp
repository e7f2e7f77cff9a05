#include "coupling/coupled_nodes.hpp"

#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace dld {

std::vector<CoupledNode> coupled_nodes(const Eigen::MatrixX3d& vertices, bool mirror) {
  std::vector<CoupledNode> nodes;
  const int n = static_cast<int>(vertices.rows());
  if (!mirror) {
    for (int i = 0; i < n; ++i) nodes.push_back({i, -1});
    return nodes;
  }
  const double tolerance = 1e-7 * vertices.rowwise().norm().maxCoeff();
  const auto key = [&](double a) { return std::llround(a / tolerance / 4); };
  std::map<std::tuple<long long, long long, long long>, int> below;
  for (int i = 0; i < n; ++i) {
    if (vertices(i, 2) < -tolerance)
      below[{key(vertices(i, 0)), key(vertices(i, 1)), key(-vertices(i, 2))}] = i;
  }
  for (int i = 0; i < n; ++i) {
    if (vertices(i, 2) < -tolerance) continue;
    if (std::abs(vertices(i, 2)) <= tolerance) {
      nodes.push_back({i, i});
      continue;
    }
    const auto partner = below.find({key(vertices(i, 0)), key(vertices(i, 1)), key(vertices(i, 2))});
    if (partner == below.end()) throw std::invalid_argument("the mesh is not mirror-symmetric about z = 0");
    nodes.push_back({i, partner->second});
  }
  return nodes;
}

}  // namespace dld
