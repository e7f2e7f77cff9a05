#pragma once
/// The list of scenes. A new scene is one file and one line in registry.cpp (and its name in the
/// parameter table).
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace dld {

Status run_streamlines(const Case& c, RunContext& context);
Status run_passage(const Case& c, RunContext& context);
Status run_stretching(const Case& c, RunContext& context);
Status run_channel(const Case& c, RunContext& context);
Status run_shear(const Case& c, RunContext& context);

/// The scene of that name, nullptr if there is none.
SceneFunction find_scene(const std::string& name);

std::vector<std::string> scene_names();

}  // namespace dld
