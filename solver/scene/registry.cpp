#include "scene/registry.hpp"

#include <array>
#include <utility>

namespace dld {
namespace {

constexpr std::array<std::pair<const char*, SceneFunction>, 5> scenes{{
    {"streamlines", run_streamlines},
    {"passage", run_passage},
    {"stretching", run_stretching},
    {"channel", run_channel},
    {"shear", run_shear},
}};

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

SceneFunction find_scene(const std::string& name) {
  for (const auto& [scene, function] : scenes) {
    if (name == scene) return function;
  }
  return nullptr;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& [scene, function] : scenes) names.emplace_back(scene);
  return names;
}

}  // namespace dld
