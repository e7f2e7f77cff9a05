#include "parameters/physical.hpp"

#include <cmath>

#include "parameters/units.hpp"

namespace dld {

using Json = nlohmann::ordered_json;

namespace {

constexpr double water_viscosity_m2_s = 1e-6;

// Stokes flow: velocities go with the stress, which a length and a tension give.
PhysicalScales of_tension(const LatticeParameters& l, double tension_N_m, const std::string& basis) {
  const double dx = 1e-6 * l.um_per_lu;
  PhysicalScales s{.um = l.um_per_lu, .tension_uN_m = 1e6 * tension_N_m, .basis = basis};
  const double velocity = tension_N_m * l.viscosity / plasma_viscosity_Pa_s;  // m/s
  s.velocity_mm_s = 1e3 * velocity;
  s.time_step_s = dx / velocity;
  return s;
}

PhysicalScales of_pressure_gradient(const Case& c, const LatticeParameters& l) {
  const SiScales si = to_si(c);
  const double dx = 1e-6 * l.um_per_lu;
  const bool own = c.operating.viscosity_mPa_s || c.operating.shear_modulus_uN_per_m;
  const std::string what = own ? "the cell and the fluid of /operating" : "a healthy cell in water";
  PhysicalScales s{.um = l.um_per_lu,
                   .time_step_s = si.time_step_s,
                   .velocity_mm_s = 1e3 * si.velocity_m_per_s_per_lu,
                   .basis = "pressure gradient that gives the case's Ca for " + what};
  if (l.force_density > 0) s.tension_uN_m = 1e6 * si.pressure_gradient_Pa_per_m / l.force_density * dx * dx;
  return s;
}

PhysicalScales of_water(const LatticeParameters& l) {
  const double dx = 1e-6 * l.um_per_lu;
  PhysicalScales s{.um = l.um_per_lu, .basis = "kinematic viscosity of water, 1e-6 m2/s"};
  s.time_step_s = l.viscosity * dx * dx / water_viscosity_m2_s;
  s.velocity_mm_s = 1e3 * dx / s.time_step_s;
  return s;
}

}  // namespace

PhysicalScales physical_scales(const Case& c) {
  const LatticeParameters l = scene_lattice(c);
  if (c.scene == "channel") return of_water(l);
  if (c.scene == "shear")
    return of_tension(l, healthy_shear_modulus_N_per_m / l.shear_modulus, "shear modulus of a healthy cell");
  if (c.scene != "stretching") return of_pressure_gradient(c, l);
  if (c.stretching.method == "static") return {.basis = "none: this scene is computed in um and pN"};
  return of_tension(l, 1e-6 * c.stretching.shear_modulus_uN_per_m / l.shear_modulus,
                    "shear modulus of the case");
}

Json physical_json(const PhysicalScales& s) {
  return {{"um_per_lu", s.um},
          {"time_step_s", s.time_step_s},
          {"velocity_mm_per_s_per_lu", s.velocity_mm_s},
          {"tension_uN_per_m_per_lu", s.tension_uN_m},
          {"basis", s.basis}};
}

Json physical_summary(const Json& summary, const PhysicalScales& s) {
  struct Entry {
    const char *lattice, *physical;
    double factor;
  };
  const double per_step = s.time_step_s > 0 ? 1e-3 / s.time_step_s : 0;  // um per step to mm/s
  const Entry entries[] = {{"mean_velocity", "mean_velocity_mm_per_s", s.velocity_mm_s},
                           {"superficial_velocity", "superficial_velocity_mm_per_s", s.velocity_mm_s},
                           {"max_speed", "max_speed_mm_per_s", s.velocity_mm_s},
                           {"speed_um_per_step", "speed_mm_per_s", per_step}};
  Json physical = Json::object();
  for (const auto& [lattice, name, factor] : entries) {
    const auto found = summary.find(lattice);
    if (factor > 0 && found != summary.end() && found->is_number())
      physical[name] = found->get<double>() * factor;
  }
  if (s.time_step_s > 0) physical["time_step_s"] = s.time_step_s;
  return physical;
}

}  // namespace dld
