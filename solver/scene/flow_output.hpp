#pragma once
/// The mid-plane flow in the output file.
#include "measure/plane_field.hpp"
#include "scene/scene.hpp"

namespace dld {

/// Writes /flow/{x_um, y_um, velocity, solid} and announces the plane to the XDMF file.
void write_plane_flow(RunContext& context, const PlaneField& field, double um_per_lu);

/// What the mean velocity (lu) of the flow without a cell says of the case: the share of epsilon that the
/// lateral flow takes, where it is more than lateral_share_limit, with what it does to s; and the operating
/// conditions, where the case gives some.
void summarise_mean_flow(const Case& c, double mean_velocity, double lateral_velocity,
                         nlohmann::ordered_json& summary);

}  // namespace dld
