#pragma once
/// JSON text to a tree, stricter than the format: a name may stand only once in an object, and objects and
/// lists stand in one another a few levels deep only.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "parameters/reader.hpp"

namespace dld {

/// Deepest nesting of objects and lists; a case needs three levels.
constexpr std::size_t deepest_json = 64;

/// Adds syntax errors, numbers that are too large and repeated names to `problems`, with JSON pointer, line
/// and column.
nlohmann::ordered_json parse_json(const std::string& text, std::vector<Problem>& problems);

}  // namespace dld
