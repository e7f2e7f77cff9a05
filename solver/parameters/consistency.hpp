#pragma once
/// Rules that join several parameters, which a JSON Schema cannot state.
#include <string>
#include <vector>

#include "parameters/case.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// All violations in a case whose parameters are each within their own range; only the rules of its scene.
std::vector<Problem> inconsistencies(const Case& c);

/// Rules of the scenes, and what they share: lengths are multiples of the lattice spacing.
void check_passage(const Case& c, std::vector<Problem>& problems);
void check_streamlines(const Case& c, std::vector<Problem>& problems);
void check_stretching(const Case& c, std::vector<Problem>& problems);
void check_channel(const Case& c, std::vector<Problem>& problems);
void check_shear(const Case& c, std::vector<Problem>& problems);

/// A length of the case that must be a multiple of `unit_um`, which is called `unit_name`.
void check_multiple(const Case& c, const std::string& pointer, double length_um, double unit_um,
                    const std::string& unit_name, bool zero_allowed, std::vector<Problem>& problems);

/// The depth on the lattice, half of it where only half is simulated.
void check_depth(const Case& c, std::vector<Problem>& problems);

}  // namespace dld
