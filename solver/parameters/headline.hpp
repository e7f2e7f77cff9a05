#pragma once
/// What a run is about to simulate, in one line.
#include <string>

#include "parameters/case.hpp"

namespace dld {

/// "passage: circle, radius 10 um, pitch 32 um, d = 6 um (epsilon 0.1875), depth 4.8 um; red_blood_cell r
/// = 3.9 um, Ca = 0.5; dx = 0.4 um (standard)": what the scene reads of it, defaults included.
std::string headline(const Case& c);

}  // namespace dld
