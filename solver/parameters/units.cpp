#include "parameters/units.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/kernel.hpp"
#include "membrane/bending_law.hpp"

namespace dld {
namespace {

int whole(double length_um, double spacing_um) {
  return static_cast<int>(std::lround(length_um / spacing_um));
}

// A length in lattice spacings; 4.8 / 0.4 is 12 and not the nearest double below it.
double spacings(double length_um, double spacing_um) {
  const double length = length_um / spacing_um, n = std::round(length);
  return std::abs(length - n) < 1e-9 * std::max(1.0, n) ? n : length;
}

}  // namespace

LatticeParameters to_lattice(const Case& c) {
  const double dx = c.fluid.lattice_spacing_um;
  LatticeParameters l;
  l.um_per_lu = dx;
  l.nx = l.ny = whole(c.geometry.pitch_um, dx);
  l.half_height = c.geometry.height == "half";
  l.nz = whole(c.geometry.depth_um, dx) / (l.half_height ? 2 : 1);
  l.row_shift = whole(c.geometry.row_shift_um, dx);
  l.pillar_radius = spacings(c.geometry.pillar_radius_um, dx);
  l.gap = spacings(c.geometry.pitch_um - 2 * c.geometry.pillar_radius_um, dx);
  l.depth = spacings(c.geometry.depth_um, dx);
  l.length_scale = std::sqrt(std::max(0.0, l.gap) * l.depth);
  l.force_density = c.fluid.force_density;
  l.viscosity = (c.fluid.relaxation_time - 0.5) / 3;
  l.tau_outside = c.fluid.relaxation_time;
  l.tau_inside = 0.5 + c.cell.viscosity_ratio * (c.fluid.relaxation_time - 0.5);
  l.cell_radius = spacings(c.cell.radius_um, dx);

  const double stress = l.force_density * l.length_scale;  // p' l
  l.tension_scale = stress * l.cell_radius;
  l.shear_modulus = l.tension_scale / c.cell.capillary_number;
  l.bending_modulus = c.cell.bending_ratio * l.shear_modulus * l.cell_radius * l.cell_radius;
  l.local_area_modulus = c.cell.local_area_modulus * l.tension_scale;
  l.global_area_modulus = c.cell.global_area_modulus * l.tension_scale;
  l.volume_modulus = c.cell.volume_modulus * stress;
  l.repulsion_strength = c.coupling.pillar_repulsion * stress;
  l.wall_repulsion_strength = c.coupling.wall_repulsion * stress;
  const double odd = c.fluid.relaxation_time - 0.5;
  l.kink_mobility = kernel_correction(c.coupling.kernel, c.cell.viscosity_ratio,
                                      c.fluid.collision == "bgk" ? odd * odd : c.fluid.magic_parameter) /
                    l.viscosity;
  return l;
}

double viscosity_Pa_s(const Case& c) {
  const auto& given = c.operating.viscosity_mPa_s;
  return given ? 1e-3 * *given : plasma_viscosity_Pa_s;
}

double shear_modulus_N_per_m(const Case& c) {
  const auto& given = c.operating.shear_modulus_uN_per_m;
  return given ? 1e-6 * *given : healthy_shear_modulus_N_per_m;
}

SiScales to_si(const Case& c) {
  return to_si(c, viscosity_Pa_s(c), shear_modulus_N_per_m(c));
}

SiScales to_si(const Case& c, double eta_Pa_s, double shear_modulus_N_per_m) {
  const LatticeParameters l = to_lattice(c);
  const double dx = 1e-6 * l.um_per_lu;
  const double area = l.length_scale * l.cell_radius * dx * dx;  // l r
  SiScales si;
  si.resistance_Pa_s_per_m2_per_lu = eta_Pa_s / (l.viscosity * dx * dx);
  // A scene without gap or drive (shear, stretching) has no such scales.
  if (area <= 0 || l.force_density <= 0) return si;
  si.pressure_gradient_Pa_per_m = c.cell.capillary_number * shear_modulus_N_per_m / area;
  si.velocity_m_per_s_per_lu =
      si.pressure_gradient_Pa_per_m / (l.force_density * si.resistance_Pa_s_per_m2_per_lu);
  si.time_step_s = dx / si.velocity_m_per_s_per_lu;
  return si;
}

double fold_modulus_N_m(const Case& c) {
  return fold_modulus_N_m(c, shear_modulus_N_per_m(c));
}

double fold_modulus_N_m(const Case& c, double shear_modulus_N_per_m) {
  const double radius_m = 1e-6 * c.cell.radius_um;
  const double modulus = c.cell.bending_ratio * shear_modulus_N_per_m * radius_m * radius_m;
  return entry(bending_law_by_name(c.cell.bending_law)).fold_ratio * modulus;
}

}  // namespace dld
