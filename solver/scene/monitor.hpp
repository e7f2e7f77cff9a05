#pragma once
/// Cheap checks during a run: a failing run stops with the quantity, its place and the likely cure.
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "membrane/membrane.hpp"

namespace dld {

struct Failure {
  std::string quantity, place, advice;
  double value = 0;
};

/// The members of a summary that label a diverged run.
inline void report_failure(const Failure& failure, long step, nlohmann::ordered_json& summary) {
  summary["failing_quantity"] = failure.quantity;
  summary["failing_value"] = failure.value;
  summary["failing_step"] = step;
  summary["failing_place"] = failure.place;
  summary["advice"] = failure.advice;
}

/// Bounds beyond which a coupled run is no longer a simulation of anything.
struct MonitorLimits {
  double speed = 0.3;          ///< of a node, lattice units (Mach 0.5)
  double volume_change = 0.2;  ///< |dV| / V0
  double area_change = 0.5;    ///< |dA| / A0
  double face_ratio = 0.01;    ///< smallest face area / reference
  double penetration = 2.0;    ///< of a node into a pillar, lattice spacings
};

/// state: what was measured on the membrane; speed: of its fastest node; film: smallest distance to a pillar.
inline std::optional<Failure> check_membrane(const MembraneState& state, const Membrane& membrane,
                                             double speed, double film, const MonitorLimits& limits = {}) {
  const double volume_change = state.volume / membrane.reference_volume() - 1.0;
  const double area_change = state.area / membrane.reference_area() - 1.0;
  // Written as !(good) so that NaN counts as failed.
  if (!(speed < limits.speed)) {
    return Failure{"speed of a membrane node", "membrane",
                   "lower /fluid/force_density: the membrane is too stiff for explicit coupling", speed};
  }
  if (!(std::abs(volume_change) < limits.volume_change)) {
    return Failure{"volume of the cell", "membrane", "set /cell/volume_control to projection", volume_change};
  }
  if (!(std::abs(area_change) < limits.area_change)) {
    return Failure{"area of the cell", "membrane",
                   "raise /cell/global_area_modulus or lower /fluid/force_density", area_change};
  }
  if (!(state.min_face_ratio > limits.face_ratio)) {
    return Failure{"smallest face of the membrane", "membrane",
                   "raise /coupling/regularisation_strength or use /coupling/kernel phi4",
                   state.min_face_ratio};
  }
  if (!(film > -limits.penetration)) {
    return Failure{"penetration of the pillar", "membrane", "raise /coupling/pillar_repulsion", -film};
  }
  return std::nullopt;
}

}  // namespace dld
