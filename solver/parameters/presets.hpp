#pragma once
/// Sets of numerical settings for a wanted accuracy. A preset replaces defaults; keys that the case gives
/// stay.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "parameters/case.hpp"

namespace dld {

/// Errors of a passage at these settings against the limit of vanishing dx, in per cent; empty: not measured.
struct ExpectedError {
  std::optional<double> d_perp_percent, centre_percent, critical_capillary_percent;
};

struct Preset {
  std::string name;
  nlohmann::ordered_json settings;  ///< part of a case: sections with numbers and names
  ExpectedError error;
  std::string purpose;  ///< "a first look"
};

/// The presets, by lattice from coarse to fine. `standard` repeats the defaults of struct Case.
const std::vector<Preset>& presets();
std::vector<std::string> preset_names();
/// "draft is for a first look, standard for ...": the presets and what each is for.
std::string preset_purposes();
const Preset& preset(const std::string& name);

/// For `dld check`: the preset of the case, its expected error, and the settings in which the case departs
/// from it (there the stated error does not apply).
nlohmann::ordered_json accuracy_json(const Case& c);

}  // namespace dld
