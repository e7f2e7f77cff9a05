#include "scene/registry.hpp"

#include <vector>

namespace dld {

// Each stands in the file of its scene. A new one is a line here and a line in the list below.
Scene streamlines_scene();
Scene passage_scene();
Scene stretching_scene();
Scene channel_scene();
Scene shear_scene();

namespace {

const std::vector<Scene>& scenes() {
  // One line each, so that a new scene is a line of its own.
  // clang-format off
  static const std::vector<Scene> all{
      streamlines_scene(),
      passage_scene(),
      stretching_scene(),
      channel_scene(),
      shear_scene(),
  };
  // clang-format on
  return all;
}

}  // namespace

std::string to_string(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::displaced:
      return "displaced";
    case Status::zigzag:
      return "zigzag";
    case Status::undecided:
      return "undecided";
    case Status::diverged:
      return "diverged";
    case Status::interrupted:
      return "interrupted";
  }
  return "unknown";
}

const std::vector<SceneRules>& scene_rules() {
  static const std::vector<SceneRules> all = [] {
    std::vector<SceneRules> rules;
    for (const Scene& scene : scenes()) rules.push_back(scene.rules);
    return rules;
  }();
  return all;
}

SceneFunction find_scene(const std::string& name) {
  for (const Scene& scene : scenes()) {
    if (scene.rules.name == name) return scene.run;
  }
  return nullptr;
}

}  // namespace dld
