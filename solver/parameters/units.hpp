#pragma once
/// Conversion of a case to lattice units (dx = dt = rho0 = 1) and to SI.
#include <array>

#include "geometry/device.hpp"
#include "parameters/case.hpp"

namespace dld {

/// Everything a scene needs in lattice units (lu). Stresses scale with the driving force density, so
/// the physics depends on the dimensionless numbers of the case alone (Stokes similarity).
struct LatticeParameters {
  int nx = 0, ny = 0;  ///< nodes of the unit cell along x and y: pitches / dx
  int nz = 0;          ///< layers simulated: depth / dx, or half of it with the mirror
  int row_shift = 0;   ///< of the unit cell: d / dx, a whole number; 0 where the rows are tilted
  bool half_height = true;
  double pillar_radius = 0;               ///< of the circle about the pillar
  double gap = 0, depth = 0;              ///< G, between a pillar and its neighbour across the lane, and H
  double length_scale = 0;                ///< l = sqrt(G H)
  double force_density = 0;               ///< p', along drive
  std::array<double, 2> drive{1.0, 0.0};  ///< unit vector of the driving force
  double viscosity = 0;                   ///< nu outside the cell
  double tau_outside = 0, tau_inside = 0;
  double cell_radius = 0;                                      ///< r
  double tension_scale = 0;                                    ///< p' l r, unit of all membrane moduli
  double shear_modulus = 0;                                    ///< kS
  double bending_modulus = 0;                                  ///< kB
  double local_area_modulus = 0;                               ///< kalpha
  double global_area_modulus = 0;                              ///< kA
  double volume_modulus = 0;                                   ///< kV
  double repulsion_strength = 0, wall_repulsion_strength = 0;  ///< K, lu of force
  double shear_rate = 0;                                       ///< gdot of the scene shear
  double um_per_lu = 0;                                        ///< dx in um
};

/// The device of the case, whatever its scene.
LatticeParameters to_lattice(const Case& c);

/// The device of a case whose pillar has no problems: lengths in um, and in lattice units with the unit cell
/// of to_lattice.
Device device_um(const Case& c);
Device device_lu(const Case& c);

/// What the scene of the case simulates: its own box and moduli instead of those of the device. The static
/// tweezer has no lattice: its radius is in um, its moduli are in uN/m and pN um, and um_per_lu is 0.
LatticeParameters scene_lattice(const Case& c);

/// kS (lu) in the coupled tweezer, whose result does not depend on it: stiff enough to relax soon, soft
/// enough for the explicit coupling. Its other moduli are the case's times this.
constexpr double coupled_stretching_shear_modulus = 0.02;

/// SI scales for a fluid of viscosity eta_Pa_s and a membrane of shear modulus kS_N_per_m.
struct SiScales {
  double pressure_gradient_Pa_per_m = 0;     ///< p' that gives the case's Ca: Ca kS / (l r)
  double velocity_m_per_s_per_lu = 0;        ///< a lattice velocity in m/s at that p'
  double time_step_s = 0;                    ///< dt
  double resistance_Pa_s_per_m2_per_lu = 0;  ///< multiply force_density / u (lu) by this: eta / (nu dx^2)
};

/// Water-like plasma, and a healthy red cell (Suresh et al., Acta Biomaterialia 1, 2005).
constexpr double plasma_viscosity_Pa_s = 1e-3, healthy_shear_modulus_N_per_m = 5.3e-6;

/// Those that the case gives in /operating, or else plasma and a healthy cell.
double viscosity_Pa_s(const Case& c);
double shear_modulus_N_per_m(const Case& c);

SiScales to_si(const Case& c, double eta_Pa_s, double shear_modulus_N_per_m = healthy_shear_modulus_N_per_m);
SiScales to_si(const Case& c);

/// Modulus that a membrane of the case's bending law feels when it is folded about one axis, N m.
double fold_modulus_N_m(const Case& c, double shear_modulus_N_per_m);
double fold_modulus_N_m(const Case& c);

}  // namespace dld
