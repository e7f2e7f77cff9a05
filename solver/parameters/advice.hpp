#pragma once
/// Advice for names that a case does not know and for lengths that its lattice does not have.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "parameters/case.hpp"
#include "parameters/declaration.hpp"

namespace dld {

/// For a name that none of the `known` ones of its section is, with the value that it was given: the key that
/// the symbol stands for, the place where the name belongs, or the name that looks most like it.
std::string unknown_name_advice(const std::string& name, const nlohmann::ordered_json& value,
                                const std::vector<std::string>& known, const Case& c);

/// For a text that is none of the allowed ones: the one that looks like it, or what the texts are for.
std::string unknown_text_advice(const std::string& given, const Allowed& allowed);

/// "a /fluid/lattice_spacing_um of 0.475, which fits all lengths": the nearest spacings, coarser and finer,
/// of which every length of the scene is a multiple, within a factor of two; "another
/// /fluid/lattice_spacing_um" if there is none.
std::string fitting_spacings(const Case& c);

}  // namespace dld
