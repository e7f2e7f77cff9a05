#pragma once
/// Which vertices of a mesh are coupled to the fluid: all of them, or one of each mirror pair.
#include <Eigen/Core>
#include <vector>

namespace dld {

/// A node that takes part in the coupling. With the mirror plane: its image below the plane (or itself, if
/// it lies on the plane) and the share of its force that the upper half feels directly.
struct CoupledNode {
  int vertex = 0;
  int mirror_vertex = -1;  ///< -1: no mirror; == vertex: on the mirror plane
};

/// All vertices (full height), or those with z >= 0 paired with their mirror images (half height). Throws
/// std::invalid_argument when the vertices are not mirror-symmetric about z = 0.
std::vector<CoupledNode> coupled_nodes(const Eigen::MatrixX3d& vertices, bool mirror);

}  // namespace dld
