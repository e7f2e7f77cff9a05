#include "parameters/scene_rules.hpp"

#include <algorithm>
#include <stdexcept>

namespace dld {

const SceneRules& rules_of(const std::string& scene) {
  const auto found = std::ranges::find(scene_rules(), scene, &SceneRules::name);
  if (found == scene_rules().end()) throw std::out_of_range("no scene " + scene);
  return *found;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& rules : scene_rules()) names.push_back(rules.name);
  return names;
}

}  // namespace dld
