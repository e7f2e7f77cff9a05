#pragma once
/// Many cases at once, for programs that plan runs: what each resolves to, what is wrong with it, what it
/// costs.
#include <nlohmann/json.hpp>
#include <string>

namespace dld {

/// The answer for the tree of one case, whose mesh files are relative to `folder`:
///   problems   [{pointer, value, allowed, advice}], all of them; without any there is also
///   case       with all defaults;  sections  of it that its scene reads
///   warnings   [{name, value, limit, unit, advice}], margins that do not hold
///   expected_to_diverge, memory_bytes, expected_cost;  operating  the case in SI units
nlohmann::ordered_json resolved_json(const nlohmann::ordered_json& root, const std::string& folder);

/// The answers for a text that holds an array of cases, or one case; throws CaseError if it is no JSON.
/// `name` stands for the file in messages.
nlohmann::ordered_json resolve_text(const std::string& text, const std::string& name);

}  // namespace dld
