#pragma once
/// Rules that join device, fluid and lattice: lengths are multiples of the lattice spacing, and pillars leave
/// gaps that the lattice can resolve.
#include <string>
#include <vector>

#include "parameters/case.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// A length of the case that must be a multiple of `unit_um`, which is called `unit_name`.
void check_multiple(const Case& c, const std::string& pointer, double length_um, double unit_um,
                    const std::string& unit_name, bool zero_allowed, std::vector<Problem>& problems);

/// The pillar by itself and beside its neighbours; false if there is none to ask further.
bool check_pillar(const Case& c, std::vector<Problem>& problems);

/// Pillar, pitches and row shift or tilt, on the lattice.
void check_array(const Case& c, std::vector<Problem>& problems);

/// The depth on the lattice, half of it where only half is simulated.
void check_depth(const Case& c, std::vector<Problem>& problems);

/// No more nodes in the scene's box than can be counted.
void check_box(const Case& c, std::vector<Problem>& problems);

}  // namespace dld
