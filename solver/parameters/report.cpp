#include "parameters/report.hpp"

#include <cmath>

#include "parameters/physical.hpp"
#include "parameters/scene_rules.hpp"

namespace dld {

using Json = nlohmann::ordered_json;

Json lattice_numbers(const Case& c) {
  const LatticeParameters l = scene_lattice(c);
  if (l.um_per_lu == 0) {
    return {{"note", "no lattice: um, uN/m and pN um"},   {"cell_radius", l.cell_radius},
            {"shear_modulus", l.shear_modulus},           {"bending_modulus", l.bending_modulus},
            {"local_area_modulus", l.local_area_modulus}, {"global_area_modulus", l.global_area_modulus},
            {"volume_modulus", l.volume_modulus}};
  }
  return {{"nx", l.nx},
          {"ny", l.ny},
          {"nz", l.nz},
          {"row_shift", l.row_shift},
          {"half_height", l.half_height},
          {"pillar_radius", l.pillar_radius},
          {"gap", l.gap},
          {"depth", l.depth},
          {"length_scale", l.length_scale},
          {"force_density", l.force_density},
          {"viscosity", l.viscosity},
          {"tau_outside", l.tau_outside},
          {"tau_inside", l.tau_inside},
          {"cell_radius", l.cell_radius},
          {"tension_scale", l.tension_scale},
          {"shear_modulus", l.shear_modulus},
          {"bending_modulus", l.bending_modulus},
          {"local_area_modulus", l.local_area_modulus},
          {"global_area_modulus", l.global_area_modulus},
          {"volume_modulus", l.volume_modulus},
          {"repulsion_strength", l.repulsion_strength},
          {"wall_repulsion_strength", l.wall_repulsion_strength},
          {"um_per_lu", l.um_per_lu}};
}

namespace {

/// Where a pressure gradient drives the cell, the area moduli of the case are in units of p' l r = Ca kS;
/// elsewhere in units of kS.
double area_modulus_unit(const Case& c) {
  return c.scene == "passage" ? c.cell.capillary_number : 1;
}

void add_cell(const Case& c, Json& numbers) {
  numbers["viscosity_ratio"] = c.cell.viscosity_ratio;
  numbers["bending_ratio"] = c.cell.bending_ratio;
  numbers["local_area_per_shear_modulus"] = c.cell.local_area_modulus * area_modulus_unit(c);
  numbers["global_area_per_shear_modulus"] = c.cell.global_area_modulus * area_modulus_unit(c);
}

Json array_numbers(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double slit_speed = l.force_density * l.depth * l.depth / (12 * l.viscosity);
  Json numbers = {
      {"epsilon", c.geometry.epsilon()}, {"gap_per_pitch", l.gap / l.ny}, {"depth_per_gap", l.depth / l.gap}};
  if (c.scene == "passage") {
    numbers["cell_diameter_per_gap"] = 2 * l.cell_radius / l.gap;
    numbers["capillary_number"] = c.cell.capillary_number;
    add_cell(c, numbers);
  }
  numbers["reynolds_number_slit"] = slit_speed * l.length_scale / l.viscosity;
  return numbers;
}

}  // namespace

Json dimensionless_numbers(const Case& c) {
  if (c.scene == "passage" || c.scene == "streamlines") return array_numbers(c);
  Json numbers = Json::object();
  if (c.scene == "channel") {
    const LatticeParameters l = to_lattice(c);
    const double slit_speed = l.force_density * l.depth * l.depth / (12 * l.viscosity);
    if (c.channel.width_um > 0) numbers["width_per_depth"] = c.channel.width_um / c.geometry.depth_um;
    numbers["reynolds_number_slit"] = slit_speed * l.depth / l.viscosity;
    return numbers;
  }
  if (c.scene == "shear") {
    numbers["capillary_number"] = c.shear.capillary_number;
    numbers["reynolds_number"] = c.shear.reynolds_number;
    numbers["cell_diameter_per_box"] = 2 * c.cell.radius_um / c.shear.box_um;
  } else {
    numbers["skalak_denominator"] = c.cell.skalak_denominator;
  }
  add_cell(c, numbers);
  return numbers;
}

Json si_numbers(const Case& c) {
  const PhysicalScales scales = physical_scales(c);
  const bool device = c.scene == "passage" || c.scene == "streamlines";
  Json numbers = {{"viscosity_Pa_s", device ? viscosity_Pa_s(c) : plasma_viscosity_Pa_s}};
  if (c.scene != "channel") {
    double shear = device ? shear_modulus_N_per_m(c) : healthy_shear_modulus_N_per_m;
    if (c.scene == "stretching") shear = 1e-6 * c.stretching.shear_modulus_uN_per_m;
    numbers["shear_modulus_N_per_m"] = shear;
    numbers["fold_modulus_N_m"] = fold_modulus_N_m(c, shear);
  }
  if (device) {
    const SiScales si = to_si(c);
    numbers["pressure_gradient_bar_per_m"] = si.pressure_gradient_Pa_per_m * 1e-5;
    numbers["resistance_Pa_s_per_m2_per_lu"] = si.resistance_Pa_s_per_m2_per_lu;
  }
  if (c.scene == "shear") numbers["shear_rate_per_s"] = scene_lattice(c).shear_rate / scales.time_step_s;
  numbers.update(physical_json(scales));
  return numbers;
}

Json expected_cost(const Case& c) {
  const ExpectedWork work = rules_of(c.scene).work(c);
  return {{"steps_per_row", c.scene == "passage" ? Json(std::round(work.steps_per_row)) : Json(nullptr)},
          {"steps", std::round(work.steps)},
          {"node_updates", std::round(work.node_updates)},
          {"membrane_updates", std::round(work.membrane_updates)},
          {"seconds_on_one_core", std::round(1e4 * work.seconds_on_one_core) / 1e4}};
}

Json margins_json(const std::vector<Margin>& margins) {
  Json list = Json::array();
  for (const auto& m : margins) {
    list.push_back({{"name", m.name},
                    {"value", m.value},
                    {"limit", m.limit},
                    {"used_share", m.share},
                    {"unit", m.unit},
                    {"ok", m.ok},
                    {"violated", m.ok      ? ""
                                 : m.fails ? "diverges"
                                           : "inaccurate"},
                    {"advice", m.ok ? "" : m.advice}});
  }
  return list;
}

}  // namespace dld
