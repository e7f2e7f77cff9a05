#pragma once
/// What `dld check` prints.
#include <nlohmann/json.hpp>
#include <string>

#include "parameters/case.hpp"

namespace dld {

/// About ten lines for people, numbers with three significant digits: scene, device, cell, physical scales,
/// lattice, accuracy, cost, margins, warnings.
std::string check_text(const Case& c);

/// Everything: the resolved case and all derived numbers.
nlohmann::ordered_json check_json(const Case& c);

/// "0.0123 lu"; no unit for a number without one.
std::string quantity_text(double value, const std::string& unit);

}  // namespace dld
