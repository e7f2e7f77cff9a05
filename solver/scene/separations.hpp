#pragma once
/// The separation streamlines of a run: of the cell-free flow, below and above the gap.
#include "measure/streamlines.hpp"
#include "output/checkpoint.hpp"
#include "scene/scene.hpp"

namespace dld {

struct Separations {
  Separation downstream, upstream;
};

Separations separations(const PlaneFlow& flow);

/// Writes them as /separatrix/{downstream, upstream}, and their distances from the pillars, the separation
/// distance s among them, as separation_um, separation_upper_um and separation_shortest_um to the summary.
void write_separations(RunContext& context, const Separations& lines, double um_per_lu);

/// What write_separations needs of them: a run that goes on has no flow without the cell any more.
void save_separations(Checkpoint& checkpoint, const Separations& lines);
Separations load_separations(const Checkpoint& checkpoint);

}  // namespace dld
