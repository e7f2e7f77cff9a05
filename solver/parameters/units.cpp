#include "parameters/units.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/bending_law.hpp"
#include "parameters/cell_surface.hpp"

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

// The pillar with its lengths in lattice units.
PillarValues pillar_lu(const Case& c) {
  PillarValues pillar = c.geometry.pillar_values();
  for (const PillarParameter& p : pillar_parameters(pillar.shape)) {
    if (p.unit != "um") continue;
    for (double& length : pillar.values.find(p.name)->second)
      length = spacings(length, c.fluid.lattice_spacing_um);
  }
  return pillar;
}

}  // namespace

Device device_um(const Case& c) {
  const GeometryParameters& g = c.geometry;
  return {make_pillar(g.pillar_values()),
          g.pitch_um,
          g.pitch_across_um(),
          g.rotated_square() ? 0.0 : g.row_shift_um,
          g.depth_um,
          g.tilt()};
}

Device device_lu(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  return {make_pillar(pillar_lu(c)),
          static_cast<double>(l.nx),
          static_cast<double>(l.ny),
          static_cast<double>(l.row_shift),
          l.depth,
          c.geometry.tilt()};
}

LatticeParameters to_lattice(const Case& c) {
  const double dx = c.fluid.lattice_spacing_um;
  LatticeParameters l;
  l.um_per_lu = dx;
  l.nx = whole(c.geometry.pitch_um, dx);
  l.ny = whole(c.geometry.pitch_across_um(), dx);
  l.half_height = c.geometry.height == "half";
  l.nz = whole(c.geometry.depth_um, dx) / (l.half_height ? 2 : 1);
  const Device device = device_um(c);
  l.row_shift = whole(device.pillars().row_shift(), dx);
  l.drive = device.drive();
  l.pillar_radius = spacings(std::max(0.0, device.pillars().shape().bounding_radius()), dx);
  l.gap = spacings(device.gap(), dx);
  l.depth = spacings(c.geometry.depth_um, dx);
  l.length_scale = length_scale(l.gap, l.depth);
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
  return l;
}

namespace {

// Without a pressure gradient the moduli of the case are in units of kS (and of kS / r for the volume).
void set_moduli(const Case& c, double shear, LatticeParameters& l) {
  l.shear_modulus = shear;
  l.local_area_modulus = c.cell.local_area_modulus * shear;
  l.global_area_modulus = c.cell.global_area_modulus * shear;
  l.bending_modulus = c.cell.bending_ratio * shear * l.cell_radius * l.cell_radius;
  l.volume_modulus = c.cell.volume_modulus * shear / l.cell_radius;
}

// No pillars and no force.
void set_box(LatticeParameters& l, int nx, int ny, int nz) {
  l.nx = nx;
  l.ny = ny;
  l.nz = nz;
  l.depth = l.half_height ? 2 * nz : nz;
  l.row_shift = 0;
  l.pillar_radius = l.gap = l.length_scale = l.force_density = l.tension_scale = 0;
}

LatticeParameters shear_lattice(const Case& c) {
  LatticeParameters l = to_lattice(c);
  const int n = whole(c.shear.box_um, l.um_per_lu);
  l.half_height = false;
  set_box(l, n, n, n);
  const double a = l.cell_radius;
  l.shear_rate = c.shear.reynolds_number * l.viscosity / (a * a);
  set_moduli(c, l.viscosity * l.shear_rate * a / c.shear.capillary_number, l);
  return l;
}

LatticeParameters stretching_lattice(const Case& c) {
  LatticeParameters l = to_lattice(c);
  if (c.stretching.method == "coupled") {
    const double reach = spacings(half_box_um(c.cell), l.um_per_lu);
    const auto spacings_of = [&](double reaches) { return static_cast<int>(std::ceil(reaches * reach)); };
    l.half_height = true;
    set_box(l, spacings_of(5.6), spacings_of(4.0), spacings_of(1.2));
    set_moduli(c, coupled_stretching_shear_modulus, l);
    return l;
  }
  set_box(l, 0, 0, 0);
  l.cell_radius = c.cell.radius_um;
  l.um_per_lu = 0;
  set_moduli(c, c.stretching.shear_modulus_uN_per_m, l);
  return l;
}

}  // namespace

LatticeParameters scene_lattice(const Case& c) {
  if (c.scene == "shear") return shear_lattice(c);
  if (c.scene == "stretching") return stretching_lattice(c);
  return to_lattice(c);
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
