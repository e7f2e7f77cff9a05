#pragma once
/// The device in the output of a run: what figures and tables need to know of its shape.
#include "geometry/device.hpp"
#include "scene/scene.hpp"

namespace dld {

/// Writes /device/outline_um and the entry "device" of the summary: gaps, gap line, open area, length scale.
void write_device(RunContext& context, const Device& device, double um_per_lu);

}  // namespace dld
