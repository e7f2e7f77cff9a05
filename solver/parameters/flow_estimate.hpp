#pragma once
/// The one estimate of how fast fluid goes through the device of a case, for the margins, the control of the
/// lateral flow, the expected work and the conversion of SI operating conditions.
#include "geometry/friction.hpp"
#include "parameters/case.hpp"

namespace dld {

/// Mobility of the device, um^2, with x along the driving force and y to the left of it; solved once for each
/// geometry and then remembered.
const Mobility& device_mobility_um2(const Case& c);

/// Is the depth small against the gap (at most half of it)? Then 12 / H^2 is the friction that counts, and
/// the margins and the control of the lateral flow go by it.
bool is_shallow(const Case& c);

/// Flow through the device, lattice units.
struct FlowEstimate {
  double mean_speed = 0;     ///< along the driving force, mean over the fluid
  double largest_speed = 0;  ///< in the mid plane
  double settling_time = 0;  ///< steps in which the mean flow adapts: mobility / viscosity
  /// Share of epsilon that a free lateral flow takes: the mean flow goes this much along with the rows.
  double lateral_share = 0;
};

FlowEstimate estimate_flow(const Case& c);

/// Rate (1 / steps) at which friction slows a lateral flow down.
double lateral_friction(const Case& c);

/// Share of epsilon that a free lateral flow may take unmentioned; the paper's device has 0.09.
constexpr double lateral_share_limit = 0.2;

/// Separation distance with a lateral flow that takes `share` of epsilon, over that without: the share
/// epsilon (1 - share) of a parabola in the gap instead of epsilon (Inglis et al., Lab Chip 6, 2006).
double separation_ratio(double epsilon, double share);

}  // namespace dld
