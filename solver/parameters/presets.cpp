#include "parameters/presets.hpp"

#include <algorithm>
#include <stdexcept>

#include "parameters/reader.hpp"

namespace dld {

using Json = nlohmann::ordered_json;

// The one table of presets. Between the lattices of `standard` and `reference` tau - 1/2 grows and the force
// density falls with the number of nodes: the Reynolds number and the density variation stay, the space error
// alone changes. `draft` doubles the force density. Errors: the section Presets of
// results/accuracy_conclusions.md, and the critical Ca against its limit at d = 6.8 um in
// results/tables/phase_boundary.csv.
const std::vector<Preset>& presets() {
  static const std::vector<Preset> table = {
      {"draft",
       {{"fluid", {{"lattice_spacing_um", 0.4}, {"relaxation_time", 0.8}, {"force_density", 4.4928e-4}}},
        {"cell", {{"mesh_frequency", 8}}},
        {"coupling", {{"steps_per_update", 2}}}},
       {9.4, 16.0, {}}},
      {"standard",
       {{"fluid", {{"lattice_spacing_um", 0.4}, {"relaxation_time", 0.8}, {"force_density", 2.2464e-4}}},
        {"cell", {{"mesh_frequency", 10}}},
        {"coupling", {{"steps_per_update", 2}}}},
       {7.2, 30.0, 110.0}},
      {"reference",
       {{"fluid", {{"lattice_spacing_um", 0.2}, {"relaxation_time", 1.1}, {"force_density", 1.1232e-4}}},
        {"cell", {{"mesh_frequency", 12}}},
        {"coupling", {{"steps_per_update", 1}}}},
       {5.2, 9.6, 45.0}},
  };
  return table;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const auto& p : presets()) names.push_back(p.name);
  return names;
}

const Preset& preset(const std::string& name) {
  const auto found = std::ranges::find(presets(), name, &Preset::name);
  if (found == presets().end()) throw std::out_of_range("no preset " + name);
  return *found;
}

Json accuracy_json(const Case& c) {
  const Preset& p = preset(c.accuracy);
  const Json resolved = echo(c), settings = p.settings.flatten();
  Json departs = Json::array();
  for (const auto& [pointer, value] : settings.items()) {
    if (resolved.at(Json::json_pointer(pointer)) != value) departs.push_back(pointer);
  }
  const auto number = [](const std::optional<double>& x) { return x ? Json(*x) : Json("not measured"); };
  return {{"preset", p.name},
          {"departs_in", departs},
          {"expected_error",
           {{"d_perp_percent", number(p.error.d_perp_percent)},
            {"centre_percent", number(p.error.centre_percent)},
            {"critical_capillary_percent", number(p.error.critical_capillary_percent)}}}};
}

}  // namespace dld
