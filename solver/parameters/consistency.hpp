#pragma once
/// Rules that join several parameters, which a JSON Schema cannot state.
#include <vector>

#include "parameters/case.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// All violations in a case whose parameters are each within their own range; only the rules of its scene.
std::vector<Problem> inconsistencies(const Case& c);

}  // namespace dld
