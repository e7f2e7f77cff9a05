#pragma once
/// Operating conditions in SI units instead of a capillary number, and every case in SI units.
///
///   Ca = p' l r / kS,  l = sqrt(G H);   u = M p' / eta,  M the mobility of the device
///   (geometry/friction.hpp)
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "parameters/declaration.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// A key of the section `operating`. None has a default: a case without the section says nothing in SI units.
struct OperatingDeclaration {
  Declaration declaration;
  std::optional<double> OperatingParameters::*member;
};

const std::vector<OperatingDeclaration>& operating_declarations();

/// Is any key of the section given?
bool operating_given(const Case& c);

/// Puts the capillary number in place that the drive of the section means, and reports what is wrong with the
/// section. `capillary_given`: the case states a capillary number too. For a case that is right in all else.
void resolve_operating(Case& c, bool capillary_given, std::vector<Problem>& problems);

/// A case in SI units, for the viscosity and the shear modulus that it gives, or else plasma and a healthy
/// cell.
struct OperatingPoint {
  double capillary_number = 0;
  double pressure_gradient_Pa_per_m = 0;
  double mean_speed_um_per_s = 0;          ///< over the fluid, along x
  double flow_rate_uL_per_min_per_um = 0;  ///< per um of the channel's width, pillars included
  double wall_shear_rate_per_s = 0;        ///< 6 u / H, that of a parabola across the depth
  double time_per_row_ms = 0;              ///< of the mean flow from one pillar row to the next
};

/// `mobility_um2`: mean velocity over the fluid per force density, times the viscosity.
OperatingPoint operating_point(const Case& c, double mobility_um2);

/// The mobility along x that is expected of the case's device and lateral flow, um^2.
double expected_mobility_um2(const Case& c);

/// For `dld check` and `dld resolve`: the case both ways, and how sure the speeds are.
nlohmann::ordered_json operating_json(const Case& c);

/// For the summary of a run: expected, as measured in the flow without the cell, and the capillary number
/// that would have met the drive exactly. `mean_velocity` in lattice units.
nlohmann::ordered_json operating_summary(const Case& c, double mean_velocity);

}  // namespace dld
