#pragma once
/// Which keys of a case have an effect: by its scene, and by what its other keys say.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "parameters/case.hpp"

namespace dld {

/// Why a key changes nothing in a case, and what would.
struct NoEffect {
  std::string reason;   ///< "the scene shear does not read it"
  std::string instead;  ///< JSON pointer of the key that does what is wanted, empty if there is none
};

/// Nothing where the key of that JSON pointer has an effect.
std::optional<NoEffect> without_effect(const std::string& pointer, const Case& c);

/// One sentence for each key of the case file, `given`, that changes nothing. A case that gives every key of
/// the sections that its scene reads is one that was resolved before: nothing is said about it.
std::vector<std::string> effect_warnings(const nlohmann::ordered_json& given, const Case& c);

}  // namespace dld
