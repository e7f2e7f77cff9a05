#pragma once
/// What the parameters have to know of each scene: the reader its rules, `dld check` and `dld resolve` its
/// margins and what it will cost. The list is the registry's (scene/registry.cpp), so that a scene says all
/// of this in its own file.
#include <string>
#include <vector>

#include "parameters/case.hpp"
#include "parameters/limits.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// What a run is expected to take.
struct ExpectedWork {
  double steps = 0;             ///< time steps, or iterations of the minimiser
  double steps_per_row = 0;     ///< passage: from one pillar line to the next; 0 elsewhere
  double node_updates = 0;      ///< fluid nodes times steps
  double membrane_updates = 0;  ///< vertices times steps
  double seconds_on_one_core = 0;
};

/// Nodes of a lattice along x, y and z, solid ones included; not rounded to what fits into an int.
struct LatticeBox {
  double nx = 0, ny = 0, nz = 0;
  double nodes() const { return nx * ny * nz; }
};

struct SceneRules {
  std::string name;
  /// Sections that the scene reads; the others of a case are checked and then without effect.
  std::vector<std::string> sections;
  /// Adds the violated rules that join several parameters.
  void (*check)(const Case& c, std::vector<Problem>& problems);
  /// How far the case is from where the scene is known to fail.
  std::vector<Margin> (*margins)(const Case& c);
  ExpectedWork (*work)(const Case& c);
  /// The scene's lattice; without nodes where there is no fluid.
  LatticeBox (*box)(const Case& c);
};

/// All scenes, in the order of the registry.
const std::vector<SceneRules>& scene_rules();

/// The rules of a scene that is in the list; throws std::out_of_range for another.
const SceneRules& rules_of(const std::string& scene);

std::vector<std::string> scene_names();

}  // namespace dld
