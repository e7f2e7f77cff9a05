#include "parameters/operating.hpp"

#include <algorithm>
#include <cmath>

#include "parameters/flow_estimate.hpp"
#include "parameters/text.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;
using P = OperatingParameters;

constexpr double metres_per_um = 1e-6, Pa_per_mbar = 100, metres_per_mm = 1e-3;
// 1 uL/min is 1e-9 m^3 in 60 s.
constexpr double cubic_metres_per_s = 1e-9 / 60;
constexpr double largest_capillary_number = 1e6;

Declaration key(const char* name, double maximum, const char* unit, const char* doc) {
  return {"operating", name, nullptr, {0, maximum, true}, unit, doc};
}

// The drives, each with what it needs beside it.
struct Drive {
  const char* name;
  std::optional<double> P::*value;
  const char* partner_name = nullptr;
  std::optional<double> P::*partner = nullptr;
};

const std::vector<Drive>& drives() {
  static const std::vector<Drive> all = {
      {"pressure_gradient_Pa_per_m", &P::pressure_gradient_Pa_per_m},
      {"pressure_drop_mbar", &P::pressure_drop_mbar, "length_mm", &P::length_mm},
      {"mean_speed_um_per_s", &P::mean_speed_um_per_s},
      {"flow_rate_uL_per_min", &P::flow_rate_uL_per_min, "channel_width_um", &P::channel_width_um}};
  return all;
}

std::vector<std::string> given_drives(const P& operating) {
  std::vector<std::string> names;
  for (const Drive& drive : drives()) {
    if (operating.*drive.value) names.emplace_back(drive.name);
  }
  return names;
}

void check_partners(const P& operating, std::vector<Problem>& problems) {
  for (const Drive& drive : drives()) {
    if (!drive.partner) continue;
    const bool value = (operating.*drive.value).has_value(), partner = (operating.*drive.partner).has_value();
    if (value == partner) continue;
    const std::string there = value ? drive.name : drive.partner_name;
    const std::string missing = value ? drive.partner_name : drive.name;
    problems.push_back({"/operating/" + there,
                        number_text(*(operating.*(value ? drive.value : drive.partner))),
                        there + " together with " + missing, "add " + missing + ", or remove " + there});
  }
}

// Pressure gradient that the drive means, Pa/m.
double pressure_gradient(const Case& c) {
  const P& o = c.operating;
  if (o.pressure_gradient_Pa_per_m) return *o.pressure_gradient_Pa_per_m;
  if (o.pressure_drop_mbar) return *o.pressure_drop_mbar * Pa_per_mbar / (*o.length_mm * metres_per_mm);
  double speed = 0;
  if (o.mean_speed_um_per_s) {
    speed = *o.mean_speed_um_per_s * metres_per_um;
  } else {
    const double area = *o.channel_width_um * c.geometry.depth_um * metres_per_um * metres_per_um;
    speed = *o.flow_rate_uL_per_min * cubic_metres_per_s / area / device_mobility_um2(c).open_area;
  }
  return viscosity_Pa_s(c) * speed / (expected_mobility_um2(c) * metres_per_um * metres_per_um);
}

// l r, m^2.
double capillary_area(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double dx = metres_per_um * l.um_per_lu;
  return l.length_scale * l.cell_radius * dx * dx;
}

Json point_json(const OperatingPoint& point) {
  return {{"pressure_gradient_Pa_per_m", point.pressure_gradient_Pa_per_m},
          {"mean_speed_um_per_s", point.mean_speed_um_per_s},
          {"flow_rate_uL_per_min_per_um_of_width", point.flow_rate_uL_per_min_per_um},
          {"wall_shear_rate_per_s", point.wall_shear_rate_per_s},
          {"time_per_row_ms", point.time_per_row_ms}};
}

}  // namespace

const std::vector<OperatingDeclaration>& operating_declarations() {
  static const std::vector<OperatingDeclaration> table = {
      {key("pressure_gradient_Pa_per_m", 1e12, "Pa/m", "drive: pressure gradient along the array"),
       &P::pressure_gradient_Pa_per_m},
      {key("pressure_drop_mbar", 1e9, "mbar", "drive: pressure drop over the length length_mm of the array"),
       &P::pressure_drop_mbar},
      {key("length_mm", 1e6, "mm", "length of the array over which the pressure drops"), &P::length_mm},
      {key("mean_speed_um_per_s", 1e12, "um/s", "drive: mean speed of the fluid between the pillars"),
       &P::mean_speed_um_per_s},
      {key("flow_rate_uL_per_min", 1e12, "uL/min",
           "drive: flow rate through a channel of channel_width_um and the depth of the device"),
       &P::flow_rate_uL_per_min},
      {key("channel_width_um", 1e9, "um", "width of the channel that the flow rate goes through"),
       &P::channel_width_um},
      {key("shear_modulus_uN_per_m", 1e9, "uN/m", "kS of the membrane; without it 5.3, a healthy red cell"),
       &P::shear_modulus_uN_per_m},
      {key("viscosity_mPa_s", 1e9, "mPa s", "of the suspending fluid; without it 1, water-like plasma"),
       &P::viscosity_mPa_s}};
  return table;
}

bool operating_given(const Case& c) {
  return std::ranges::any_of(operating_declarations(),
                             [&](const auto& key) { return (c.operating.*key.member).has_value(); });
}

double expected_mobility_um2(const Case& c) {
  const Mobility& m = device_mobility_um2(c);
  return c.fluid.lateral_flow == "blocked" ? m.blocked() : m.xx;
}

void resolve_operating(Case& c, bool capillary_given, std::vector<Problem>& problems) {
  if (!operating_given(c)) return;
  const auto before = problems.size();
  const auto named = given_drives(c.operating);
  check_partners(c.operating, problems);
  if (named.size() > 1) {
    problems.push_back({"/operating", joined(named), "one drive", "remove all but one of them"});
  }
  if (named.empty() || problems.size() > before) return;
  if (c.scene != "passage" && c.scene != "streamlines") {
    problems.push_back({"/operating/" + named.front(), "", "a drive in the scenes passage and streamlines",
                        "remove it: the scene " + c.scene + " has no flow through the device"});
    return;
  }
  const double number = pressure_gradient(c) * capillary_area(c) / shear_modulus_N_per_m(c);
  if (capillary_given) {
    problems.push_back(
        {"/cell/capillary_number", number_text(c.cell.capillary_number),
         "either a capillary number or a drive in /operating, which means Ca = " + number_text(number),
         "remove one of the two"});
  } else if (!(number > 0 && number <= largest_capillary_number)) {
    problems.push_back({"/operating/" + named.front(), "Ca = " + number_text(number),
                        "a capillary number above 0 and at most " + number_text(largest_capillary_number),
                        "check the units of /operating"});
  } else {
    c.cell.capillary_number = number;
  }
}

OperatingPoint operating_point(const Case& c, double mobility_um2) {
  OperatingPoint point;
  const double area = capillary_area(c);
  if (area <= 0) return point;
  point.capillary_number = c.cell.capillary_number;
  point.pressure_gradient_Pa_per_m = c.cell.capillary_number * shear_modulus_N_per_m(c) / area;
  const double mobility = mobility_um2 * metres_per_um * metres_per_um;
  const double speed = mobility * point.pressure_gradient_Pa_per_m / viscosity_Pa_s(c);
  point.mean_speed_um_per_s = speed / metres_per_um;
  const double area_per_um = c.geometry.depth_um * metres_per_um * metres_per_um;
  point.flow_rate_uL_per_min_per_um =
      speed * device_mobility_um2(c).open_area * area_per_um / cubic_metres_per_s;
  point.wall_shear_rate_per_s = 6 * speed / (c.geometry.depth_um * metres_per_um);
  point.time_per_row_ms = 1e3 * c.geometry.pitch_um * metres_per_um / speed;
  return point;
}

Json operating_json(const Case& c) {
  if (c.scene != "passage" && c.scene != "streamlines") return nullptr;
  const OperatingPoint point = operating_point(c, expected_mobility_um2(c));
  Json json = {{"capillary_number", point.capillary_number},
               {"shear_modulus_uN_per_m", 1e6 * shear_modulus_N_per_m(c)},
               {"viscosity_mPa_s", 1e3 * viscosity_Pa_s(c)}};
  json.update(point_json(point));
  json["uncertainty_of_speeds_percent"] = 100 * friction_uncertainty;
  return json;
}

Json operating_summary(const Case& c, double mean_velocity) {
  const double dx = c.fluid.lattice_spacing_um;
  const LatticeParameters l = to_lattice(c);
  const double expected = expected_mobility_um2(c);
  const double measured = mean_velocity * l.viscosity / l.force_density * dx * dx;
  Json json = operating_json(c);
  json["measured"] = point_json(operating_point(c, measured));
  // Pressures are exact. What was asked for as a speed or a flow rate was turned into one with the estimate.
  const bool by_speed = c.operating.mean_speed_um_per_s || c.operating.flow_rate_uL_per_min;
  json["capillary_number_that_meets_the_drive"] =
      c.cell.capillary_number * (by_speed ? expected / measured : 1.0);
  return json;
}

}  // namespace dld
