#pragma once
/// Where a passage begins.
#include <Eigen/Core>

#include "geometry/device.hpp"
#include "measure/plane_field.hpp"
#include "parameters/case.hpp"

namespace dld {

/// The shape (nv x 3, centred at 0) turned and moved to where the case wants it, lattice units. By default
/// half a pitch before the first pillar line with the lower edge on the separation streamline of the
/// cell-free flow `field`, which saves several pillars; higher or lower where a pillar is in the way.
Eigen::MatrixX3d start_positions(const Case& c, const Eigen::MatrixX3d& shape, const Device& device,
                                 const PlaneField& field);

}  // namespace dld
