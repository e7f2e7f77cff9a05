#pragma once
/// The summary of a passage: one row of results, whose names are columns of the study's tables.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "geometry/device.hpp"
#include "parameters/case.hpp"
#include "scene/monitor.hpp"
#include "scene/passage_state.hpp"
#include "scene/scene.hpp"

namespace dld {

/// How a passage ended.
struct PassageEnd {
  Status status = Status::undecided;
  std::string reason;              ///< why it ended before a cell was in it
  std::optional<Failure> failure;  ///< of a diverged one
};

/// What was simulated, as far as the summary tells.
struct SimulatedSize {
  bool with_cell = false;  ///< the flow without it was steady
  long fluid_nodes = 0, vertices = 0;
  std::size_t memory_bytes = 0;  ///< of the fluid
  double mobility = 0;           ///< of the regularisation, as it was used (lu)
  long odd_columns = 0;          ///< told inside from outside by the winding number (see InsideMarker)
};

/// Adds all members to context.summary. `device` in lattice units.
void summarise_passage(const Case& c, const Device& device, const PassageState& state, const PassageEnd& end,
                       const SimulatedSize& size, RunContext& context);

}  // namespace dld
