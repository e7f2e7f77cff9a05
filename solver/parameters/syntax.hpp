#pragma once
/// JSON text to a tree, stricter than the format: a name may stand only once in an object.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "parameters/reader.hpp"

namespace dld {

/// Adds syntax errors (with line and column) and repeated names to `problems`.
nlohmann::ordered_json parse_json(const std::string& text, std::vector<Problem>& problems);

}  // namespace dld
