#include "parameters/presets.hpp"

#include <algorithm>
#include <stdexcept>

#include "parameters/reader.hpp"

namespace dld {

using Json = nlohmann::ordered_json;

namespace {

// Kernel and contact of the paper: range one lattice spacing, default law and strength.
Json plain_coupling(int steps_per_update) {
  const CouplingParameters defaults;
  return {{"kernel", defaults.kernel},
          {"pillar_repulsion", defaults.pillar_repulsion},
          {"wall_repulsion", defaults.wall_repulsion},
          {"repulsion_range", defaults.repulsion_range},
          {"steps_per_update", steps_per_update}};
}

// The corrected kernel lets the cell come as near as the contact allows, so the contact is given in um and at
// the walls too: `range`, in lattice spacings, is 0.1 um; K = range^2 times the default keeps K / h0^2.
Json corrected_coupling(double range, double strength) {
  return {{"kernel", "phi4_corrected"},
          {"pillar_repulsion", strength},
          {"wall_repulsion", strength},
          {"repulsion_range", range},
          {"steps_per_update", 1}};
}

Json lattice(double spacing_um, const char* walls, double relaxation_time, double force_density) {
  return {{"lattice_spacing_um", spacing_um},
          {"walls", walls},
          {"relaxation_time", relaxation_time},
          {"force_density", force_density}};
}

}  // namespace

// The one table of presets. Edges of the mesh are a lattice spacing long: cells fold at a pillar with a
// radius of 0.4 um, an edge of the mesh of frequency 10. `draft` doubles the force density of `standard`;
// `refined` keeps its Reynolds number on the finer lattice, where tau - 1/2 grows and the force density
// falls with the number of nodes. The corrected kernel resolves a film that interpolated walls would squeeze:
// central linear walls, and for these tau is free, so that it takes the inertia down (a seventh of that of
// `standard`, with twice the steps), as far as the bending stiffness is borne. Errors: the section
// Presets of results/accuracy_conclusions.md; of the critical
// Ca none is stated while the bracket of `reference` is wide (results/tables/boundary_uncertainty.csv).
const std::vector<Preset>& presets() {
  const auto row = [](const char* name, Json fluid, int mesh_frequency, Json coupling, ExpectedError error,
                      const char* purpose) {
    return Preset{name,
                  {{"fluid", std::move(fluid)},
                   {"cell", {{"mesh_frequency", mesh_frequency}}},
                   {"coupling", std::move(coupling)}},
                  error,
                  purpose};
  };
  static const std::vector<Preset> table = {
      row("draft", lattice(0.4, "interpolated", 0.8, 4.4928e-4), 8, plain_coupling(2), {4.1, 15.6, {}},
          "a first look"),
      row("standard", lattice(0.4, "interpolated", 0.8, 2.2464e-4), 10, plain_coupling(2), {3.8, 15.8, {}},
          "studies on the paper's lattice"),
      row("corrected", lattice(0.4, "central_linear", 1.5, 3.744e-4), 10, corrected_coupling(0.25, 0.176),
          {8.0, 20.4, {}}, "contact with the pillars on the paper's lattice"),
      row("refined", lattice(0.2, "interpolated", 1.1, 1.1232e-4), 20, plain_coupling(1), {2.4, 7.8, {}},
          "the same model on half the spacing"),
      row("reference", lattice(0.2, "central_linear", 1.6, 1.1232e-4), 20, corrected_coupling(0.5, 0.704),
          {3.1, 7.6, {}}, "the most accurate results"),
  };
  return table;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const auto& p : presets()) names.push_back(p.name);
  return names;
}

std::string preset_purposes() {
  std::string text;
  for (const auto& p : presets()) text += (text.empty() ? "" : ", ") + p.name + " is for " + p.purpose;
  return text;
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
