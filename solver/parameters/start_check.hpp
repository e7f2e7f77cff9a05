#pragma once
/// Rules that join the start of a cell with the device around it.
#include <vector>

#include "parameters/case.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// Before the first pillar line, between the walls and clear of the pillars.
void check_start(const Case& c, std::vector<Problem>& problems);

}  // namespace dld
