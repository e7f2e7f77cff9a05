#include "parameters/report.hpp"

#include <cmath>

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
  return {{"viscosity_Pa_s", plasma_viscosity_Pa_s},
          {"shear_modulus_N_per_m", healthy_shear_modulus_N_per_m},
          {"fold_modulus_N_m", fold_modulus_N_m(c)},
          {"pressure_gradient_bar_per_m", si.pressure_gradient_Pa_per_m * 1e-5},
          {"velocity_mm_per_s_per_lu", si.velocity_m_per_s_per_lu * 1e3},
          {"time_step_s", si.time_step_s},
          {"resistance_Pa_s_per_m2_per_lu", si.resistance_Pa_s_per_m2_per_lu}};
}

Json expected_cost(const Case& c) {
  if (c.scene != "passage" && c.scene != "streamlines") return nullptr;
  constexpr double rate = 150e6, typical_rows = 10, array_share = 0.6;
  const LatticeParameters l = to_lattice(c);
  const double nodes = static_cast<double>(l.nx) * l.ny * l.nz *
                       (1 - 3.14 * l.pillar_radius * l.pillar_radius / (static_cast<double>(l.nx) * l.ny));
  const double slit_speed = l.force_density * l.depth * l.depth / (12 * l.viscosity);
  const double diffusion_steps =
      l.depth * l.depth / l.viscosity;  // the flow settles within about two of these
  const double per_row = l.nx / (array_share * slit_speed);
  const double steps = 2 * diffusion_steps + (c.scene == "passage" ? typical_rows * per_row : 0);
  return {{"steps_per_row", c.scene == "passage" ? Json(std::round(per_row)) : Json(nullptr)},
          {"steps", std::round(steps)},
          {"node_updates", std::round(steps * nodes)},
          {"seconds_on_one_core", std::round(steps * nodes / rate)}};
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
