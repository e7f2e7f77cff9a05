#pragma once
/// Physical units beside lattice units: what a lattice length, velocity, time and tension of a case are.
#include <nlohmann/json.hpp>
#include <string>

#include "parameters/case.hpp"

namespace dld {

/// Values of one lattice unit; 0 where the scene has no such scale. In Stokes flow they follow from one
/// force: `basis` says which.
struct PhysicalScales {
  double um = 0;             ///< of a lattice spacing
  double time_step_s = 0;    ///< s of a time step
  double velocity_mm_s = 0;  ///< mm/s of a lattice velocity
  double tension_uN_m = 0;   ///< uN/m of a lattice tension (force / length)
  std::string basis;
};

PhysicalScales physical_scales(const Case& c);

/// The same by name, as it stands in the root of an output file.
nlohmann::ordered_json physical_json(const PhysicalScales& scales);

/// Physical values of what a summary gives in lattice units: velocities in mm/s.
nlohmann::ordered_json physical_summary(const nlohmann::ordered_json& summary, const PhysicalScales& scales);

}  // namespace dld
