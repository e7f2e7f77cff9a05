#pragma once
/// One value of a case file against its declaration.
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "parameters/declaration.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// Puts the value in its place in a case if it is right; else adds the problem, and the place keeps what it
/// has.
void store_value(const Declaration& declaration, const nlohmann::ordered_json& value, const Field& place,
                 std::vector<Problem>& problems);

/// A number whose place is not a member of the case; none, and a problem, if it is not right.
std::optional<double> declared_number(const Declaration& declaration, const nlohmann::ordered_json& value,
                                      std::vector<Problem>& problems);

}  // namespace dld
