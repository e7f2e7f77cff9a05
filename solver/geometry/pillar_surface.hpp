#pragma once
/// The wall of a pillar as triangles.
#include <Eigen/Core>

#include "geometry/pillar.hpp"

namespace dld {

/// Triangles of a surface; no vertex is there twice.
struct Surface {
  Eigen::MatrixX3d vertices;   ///< (n, 3), length unit of the shape
  Eigen::MatrixX3i triangles;  ///< (m, 3), vertices of each triangle
};

/// Side wall over the outline of the shape, between z = -half_height and z = +half_height, without lids;
/// empty where there is no pillar.
Surface pillar_wall(const PillarShape& shape, double half_height);

}  // namespace dld
