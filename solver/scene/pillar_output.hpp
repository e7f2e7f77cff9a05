#pragma once
/// The pillars around a path, as a surface in the output file.
#include <set>
#include <utility>
#include <vector>

#include "geometry/pillar_array.hpp"
#include "scene/scene.hpp"

namespace dld {

/// Whole numbers (n, m) of a pillar, which stands at (n pitch, m pitch + n d).
using PillarPlaces = std::set<std::pair<long, long>>;

/// The four pillars around each point (x, y) of a path, lattice units.
PillarPlaces pillars_along(const PillarArray& pillars, const std::vector<double>& x,
                           const std::vector<double>& y);

/// Writes /pillars/{centres_um, points_um, triangles} for pillars between z = -+ half_height (lu) and
/// announces the surface to the XDMF file; nothing in an empty slit.
void write_pillars(RunContext& context, const PillarArray& pillars, const PillarPlaces& places,
                   double half_height, double um_per_lu);

}  // namespace dld
