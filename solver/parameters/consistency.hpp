#pragma once
/// Rules that join several parameters, which a JSON Schema cannot state.
#include <vector>

#include "parameters/case.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// All violations in a case whose parameters are each within their own range; only the rules of its scene.
std::vector<Problem> inconsistencies(const Case& c);

/// Rules of the scenes, on top of those that each of them takes from device, start and cell
/// (device_check.hpp, start_check.hpp, cell_check.hpp).
void check_passage(const Case& c, std::vector<Problem>& problems);
void check_streamlines(const Case& c, std::vector<Problem>& problems);
void check_stretching(const Case& c, std::vector<Problem>& problems);
void check_channel(const Case& c, std::vector<Problem>& problems);
void check_shear(const Case& c, std::vector<Problem>& problems);

}  // namespace dld
