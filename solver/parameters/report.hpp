#pragma once
/// The derived numbers of a case, as they go into the output and into `dld check`.
#include <nlohmann/json.hpp>

#include "parameters/case.hpp"
#include "parameters/limits.hpp"
#include "parameters/memory.hpp"
#include "parameters/units.hpp"

namespace dld {

/// The members of LatticeParameters by name, as the scene simulates them.
nlohmann::ordered_json lattice_numbers(const Case& c);

/// The dimensionless numbers that the scene has: epsilon, Ca, the moduli in units of kS, confinement, Re.
nlohmann::ordered_json dimensionless_numbers(const Case& c);

/// SI numbers for the fluid and the membrane of /operating, or else water-like fluid (1 mPa s) and a healthy
/// cell (5.3 uN/m; a stretched cell has the case's), and what a lattice unit is.
nlohmann::ordered_json si_numbers(const Case& c);

/// What a run will cost: steps (of a passage also per pillar row), node updates, updates of membrane vertices
/// and seconds on a core with AVX-512.
nlohmann::ordered_json expected_cost(const Case& c);

nlohmann::ordered_json margins_json(const std::vector<Margin>& margins);

}  // namespace dld
