#pragma once
/// The mid-plane flow in the output file.
#include <Eigen/Core>

#include "measure/plane_field.hpp"
#include "parameters/physical.hpp"
#include "scene/scene.hpp"

namespace dld {

/// Writes /flow/{x_um, y_um, velocity, solid, points_um}, on the nodes of the unit cell, and
/// /flow/around/{points_um, quads, velocity_mm_per_s, solid}: the same nodes where they are around `centre`
/// (lu), that is within half a pitch of it, for viewers. Announces the latter to the XDMF file.
void write_plane_flow(RunContext& context, const PlaneField& field, const PhysicalScales& scales,
                      const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

/// What the mean velocity (lu, along and across the driving force) of the flow without a cell says of the
/// case: the share of epsilon that the lateral flow takes, where it is more than lateral_share_limit, with
/// what it does to s; and the operating conditions, where the case gives some.
void summarise_mean_flow(const Case& c, double along, double across, nlohmann::ordered_json& summary);

}  // namespace dld
