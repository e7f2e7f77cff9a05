#include "parameters/effect.hpp"

#include <algorithm>

#include "parameters/cell_surface.hpp"
#include "parameters/declaration.hpp"
#include "parameters/reader.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;

/// Sets of what can run; the tweezer counts twice, since its two methods have little in common.
enum Scene : unsigned {
  passage = 1,
  streamlines = 2,
  channel = 4,
  shear = 8,
  tweezer_static = 16,
  tweezer_coupled = 32,
};
constexpr unsigned tweezer = tweezer_static | tweezer_coupled, device = passage | streamlines,
                   coupled = passage | shear | tweezer_coupled, with_cell = coupled | tweezer_static,
                   with_fluid = device | channel | shear | tweezer_coupled;

struct Instead {
  unsigned scenes;
  const char* pointer;
};

/// Who reads a key or, for all of its keys without a line of their own, a section.
struct ReadBy {
  std::string_view pointer;
  unsigned scenes;
  bool (*condition)(const Case&) = nullptr;  ///< that must hold besides; nullptr for none
  const char* condition_text = "";           ///< "/fluid/collision is trt"
  std::vector<Instead> instead = {};         ///< what does the same in the scenes that do not read it
};

bool penalty(const Case& c) {
  return c.cell.volume_control == "penalty" || (c.scene == "stretching" && c.stretching.method == "static");
}
bool contrast(const Case& c) {
  return c.cell.viscosity_ratio != 1;
}
bool repelled(const Case& c) {
  return c.coupling.wall_repulsion > 0 || (c.scene == "passage" && c.coupling.pillar_repulsion > 0);
}
constexpr const char* if_contrast = "/cell/viscosity_ratio is not 1";

const std::vector<ReadBy>& readings() {
  static const std::vector<ReadBy> table = {
      {"/geometry", device},
      {"/geometry/pitch_um", device, nullptr, "", {{channel, "/channel/width_um"}, {shear, "/shear/box_um"}}},
      {"/geometry/depth_um", device | channel, nullptr, "", {{shear, "/shear/box_um"}}},
      {"/geometry/height", device | channel},
      {"/geometry/surface_nodes", device | channel},
      {"/fluid", with_fluid},
      {"/fluid/magic_parameter", with_fluid, [](const Case& c) { return c.fluid.collision == "trt"; },
       "/fluid/collision is trt"},
      {"/fluid/walls", device | channel,
       [](const Case& c) { return c.scene != "channel" || c.channel.width_um > 0; },
       "/channel/width_um is above 0"},
      {"/fluid/force_density",
       device | channel,
       nullptr,
       "",
       {{shear, "/shear/reynolds_number"}, {tweezer, "/stretching/forces_pN"}}},
      {"/fluid/lateral_flow", device},
      {"/cell", with_cell},
      {"/cell/capillary_number",
       passage,
       nullptr,
       "",
       {{shear, "/shear/capillary_number"}, {tweezer, "/stretching/shear_modulus_uN_per_m"}}},
      {"/cell/volume_control", coupled},
      {"/cell/volume_modulus", with_cell, penalty, "/cell/volume_control is penalty"},
      {"/cell/viscosity_ratio", coupled},
      {"/cell/viscosity_field", coupled, contrast, if_contrast},
      {"/cell/viscosity_update_interval", coupled, contrast, if_contrast},
      {"/cell/mesh_frequency", with_cell, [](const Case& c) { return c.cell.shape != "mesh"; },
       "/cell/shape is none from a file"},
      {"/cell/semi_axes_um", with_cell, [](const Case& c) { return c.cell.shape == "ellipsoid"; },
       "/cell/shape is ellipsoid"},
      {"/cell/mesh_file", with_cell, [](const Case& c) { return c.cell.shape == "mesh"; },
       "/cell/shape is mesh"},
      {"/cell/start", passage},
      {"/coupling", coupled},
      {"/coupling/regularisation_strength", coupled,
       [](const Case& c) { return c.coupling.regularisation == "tangential"; },
       "/coupling/regularisation is tangential"},
      {"/coupling/pillar_repulsion", passage},
      {"/coupling/repulsion_range", coupled, repelled,
       "something repels: /coupling/wall_repulsion is above 0"},
      {"/stop", passage},
      {"/stop/max_rows",
       passage,
       nullptr,
       "",
       {{streamlines | channel | tweezer_coupled, "/stop/max_steps"}, {shear, "/shear/duration"}}},
      {"/stop/map_tolerance_um", passage, nullptr, "", {{streamlines | channel, "/stop/steady_tolerance"}}},
      {"/stop/steady_tolerance", device | channel},
      {"/stop/max_steps", device | channel | tweezer_coupled, nullptr, "", {{shear, "/shear/duration"}}},
      {"/operating", device},
      {"/stretching", tweezer},
      {"/stretching/shear_modulus_uN_per_m",
       tweezer,
       nullptr,
       "",
       {{passage, "/cell/capillary_number"}, {shear, "/shear/capillary_number"}}},
      {"/shear", shear},
      {"/shear/capillary_number",
       shear,
       nullptr,
       "",
       {{passage, "/cell/capillary_number"}, {tweezer, "/stretching/shear_modulus_uN_per_m"}}},
      {"/shear/reynolds_number", shear, nullptr, "", {{device | channel, "/fluid/force_density"}}},
      {"/shear/duration",
       shear,
       nullptr,
       "",
       {{passage, "/stop/max_rows"}, {streamlines | channel | tweezer_coupled, "/stop/max_steps"}}},
      {"/channel", channel},
      {"/channel/width_um", channel, nullptr, "", {{device, "/geometry/pitch_um"}, {shear, "/shear/box_um"}}},
      {"/output", passage},
      {"/output/flow_field", device},
  };
  return table;
}

unsigned scene_of(const Case& c) {
  if (c.scene == "stretching") return c.stretching.method == "coupled" ? tweezer_coupled : tweezer_static;
  if (c.scene == "streamlines") return streamlines;
  if (c.scene == "channel") return channel;
  return c.scene == "shear" ? shear : passage;
}

std::string scene_text(const Case& c) {
  return "the scene " + c.scene + (c.scene == "stretching" ? " (" + c.stretching.method + ")" : "");
}

/// The line of a key, or else of the section that it is in; nullptr for what stands outside of all sections.
const ReadBy* reading(std::string pointer) {
  while (!pointer.empty()) {
    const auto found = std::ranges::find(readings(), pointer, &ReadBy::pointer);
    if (found != readings().end()) return &*found;
    pointer.resize(pointer.rfind('/'));
  }
  return nullptr;
}

/// Whether the case gives every key with a default of the sections that its scene reads.
bool resolved_before(const Json& given, const Case& c) {
  const Json all = echo(Case{});
  return std::ranges::all_of(declarations(), [&](const Declaration& d) {
    const Json::json_pointer key(d.pointer());
    const ReadBy* line = d.section.empty() ? nullptr : reading("/" + std::string(d.section));
    if (!line || (line->scenes & scene_of(c)) == 0 || !all.contains(key) || given.contains(key)) return true;
    // What another key stands for: a row shift that follows from epsilon, a radius that follows from the
    // shape.
    return (d.name == "row_shift_um" && given.contains(Json::json_pointer("/geometry/epsilon"))) ||
           (d.pointer() == "/cell/radius_um" && !sized_by_radius(c.cell));
  });
}

/// Pointers of all keys of a case file; a list is the value of one key.
void collect_keys(const Json& object, const std::string& path, std::vector<std::string>& keys) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_object()) {
      collect_keys(value, path + "/" + name, keys);
    } else {
      keys.push_back(path + "/" + name);
    }
  }
}

}  // namespace

std::optional<NoEffect> without_effect(const std::string& pointer, const Case& c) {
  const ReadBy* line = reading(pointer);
  if (!line) return std::nullopt;
  const unsigned scene = scene_of(c);
  if ((line->scenes & scene) == 0) {
    NoEffect none{scene_text(c) + " does not read it", ""};
    for (const Instead& key : line->instead) {
      if ((key.scenes & scene) != 0) none.instead = key.pointer;
    }
    return none;
  }
  if (!line->condition || line->condition(c)) return std::nullopt;
  return NoEffect{std::string("it is used where ") + line->condition_text, ""};
}

std::vector<std::string> effect_warnings(const Json& given, const Case& c) {
  std::vector<std::string> keys, warnings;
  collect_keys(given, "", keys);
  if (resolved_before(given, c)) return warnings;
  std::vector<std::pair<std::string, std::vector<std::string>>> unread;  // sections, and keys of each
  for (const std::string& key : keys) {
    const auto none = without_effect(key, c);
    if (!none) continue;
    if (!none->instead.empty() || none->reason.starts_with("it is used")) {
      warnings.push_back(key + " has no effect: " + none->reason +
                         (none->instead.empty() ? "" : "; use " + none->instead));
      continue;
    }
    const std::string section = key.substr(0, key.rfind('/')), name = key.substr(key.rfind('/') + 1);
    if (unread.empty() || unread.back().first != section) unread.push_back({section, {}});
    unread.back().second.push_back(name);
  }
  for (const auto& [section, names] : unread) {
    warnings.push_back((names.size() == 1 ? section + "/" + names.front() + " has no effect: "
                                          : section + " (" + joined(names) + ") has no effect: ") +
                       scene_text(c) + " does not read " + (names.size() == 1 ? "it" : "these keys"));
  }
  return warnings;
}

}  // namespace dld
