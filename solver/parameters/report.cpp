#include "parameters/report.hpp"

#include <cmath>

#include "parameters/scene_rules.hpp"

namespace dld {

using Json = nlohmann::ordered_json;

Json lattice_numbers(const Case& c) {
  const LatticeParameters l = to_lattice(c);
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

Json dimensionless_numbers(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  const double slit_speed = l.force_density * l.depth * l.depth / (12 * l.viscosity);
  return {{"epsilon", c.geometry.row_shift_um / c.geometry.pitch_um},
          {"gap_per_pitch", l.gap / l.nx},
          {"depth_per_gap", l.depth / l.gap},
          {"cell_diameter_per_gap", 2 * l.cell_radius / l.gap},
          {"capillary_number", c.cell.capillary_number},
          {"viscosity_ratio", c.cell.viscosity_ratio},
          {"bending_ratio", c.cell.bending_ratio},
          {"local_area_per_shear_modulus", c.cell.local_area_modulus * c.cell.capillary_number},
          {"global_area_per_shear_modulus", c.cell.global_area_modulus * c.cell.capillary_number},
          {"reynolds_number_slit", slit_speed * l.length_scale / l.viscosity}};
}

Json si_numbers(const Case& c) {
  const SiScales si = to_si(c);
  return {{"viscosity_Pa_s", viscosity_Pa_s(c)},
          {"shear_modulus_N_per_m", shear_modulus_N_per_m(c)},
          {"fold_modulus_N_m", fold_modulus_N_m(c)},
          {"pressure_gradient_bar_per_m", si.pressure_gradient_Pa_per_m * 1e-5},
          {"velocity_mm_per_s_per_lu", si.velocity_m_per_s_per_lu * 1e3},
          {"time_step_s", si.time_step_s},
          {"resistance_Pa_s_per_m2_per_lu", si.resistance_Pa_s_per_m2_per_lu}};
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
