#pragma once
/// The wall of a pillar as triangles, from its distance function alone: any shape that has one can be drawn.
#include <Eigen/Core>

#include "geometry/pillar.hpp"

namespace dld {

/// Triangles of a surface; no vertex is there twice.
struct Surface {
  Eigen::MatrixX3d vertices;   ///< (n, 3), length unit of the shape
  Eigen::MatrixX3i triangles;  ///< (m, 3), vertices of each triangle
};

/// Side wall between z = -half_height and z = +half_height, without lids; empty where there is no pillar. Its
/// outline is the zero line of the distance on a grid of `resolution` spacings across the shape (marching
/// triangles): its vertices lie on the surface, so that a chord leaves it by (spacing)^2 / (4 radius of
/// curvature) at most.
Surface pillar_wall(const PillarShape& shape, double half_height, int resolution = 64);

}  // namespace dld
