#pragma once
/// The list of scenes. A new scene is one file, which defines a function that returns its `Scene`, and its
/// name in registry.cpp.
#include <string>

#include "parameters/scene_rules.hpp"
#include "scene/scene.hpp"

namespace dld {

/// A scene: what is known of it before it runs, and how it runs.
struct Scene {
  SceneRules rules;
  SceneFunction run;
};

/// The scene of that name, nullptr if there is none.
SceneFunction find_scene(const std::string& name);

}  // namespace dld
