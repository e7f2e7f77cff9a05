#pragma once
/// What a run will cost, by scene: time steps, node updates, memory. Estimates within a factor of
/// two or three, good for an order of jobs, a budget and a limit of time.
#include "parameters/scene_rules.hpp"

namespace dld {

ExpectedWork passage_work(const Case& c);
ExpectedWork streamlines_work(const Case& c);
ExpectedWork stretching_work(const Case& c);
ExpectedWork channel_work(const Case& c);
ExpectedWork shear_work(const Case& c);

LatticeBox passage_box(const Case& c);
LatticeBox streamlines_box(const Case& c);
LatticeBox stretching_box(const Case& c);
LatticeBox channel_box(const Case& c);
LatticeBox shear_box(const Case& c);

}  // namespace dld
