#pragma once
/// The mid-plane flow in the output file.
#include "measure/plane_field.hpp"
#include "scene/scene.hpp"

namespace dld {

/// Writes /flow/{x_um, y_um, velocity, solid} and announces the plane to the XDMF file.
void write_plane_flow(RunContext& context, const PlaneField& field, double um_per_lu);

}  // namespace dld
