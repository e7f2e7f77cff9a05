#pragma once
/// A case: everything one run needs, as the user wrote it (lengths in um, dimensionless numbers as
/// the field defines them). Defaults stand here once; the reader and the schema take them from here.
/// Conversion to lattice units is in units.hpp.
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pillar.hpp"

namespace dld {

struct CellSurface;

struct GeometryParameters {
  std::string pillar_shape = "circle";  ///< "circle" | "none" for an empty slit: the short form of pillar
  double pillar_radius_um = 10.0;       ///< R of the short form
  std::optional<PillarValues> pillar;   ///< any shape, lengths in um; replaces the two above
  double pitch_um = 32.0;               ///< lambda along x, and along y unless pitch_y_um is given
  std::optional<double> pitch_y_um;     ///< pitch across the flow
  double row_shift_um = 6.0;            ///< d; the case may give epsilon = d / pitch across the flow instead
  bool by_epsilon = false;              ///< it gave epsilon; not a parameter of its own
  std::optional<std::string> layout;    ///< "row_shifted" (absent) | "rotated_square"
  double depth_um = 4.8;                ///< H, between the bottom and the top wall
  std::string pillar_center = "node";   ///< "node" | "between_nodes" (in x and y)
  std::string surface_nodes = "solid";  ///< a node exactly on the surface is "solid" | "fluid"
  std::string height = "half";          ///< "half" (mirror plane at z = 0) | "full"

  double pitch_across_um() const { return pitch_y_um.value_or(pitch_um); }
  /// An unshifted square array whose rows are tilted by atan(epsilon) against the flow.
  bool rotated_square() const { return layout == "rotated_square"; }
  /// Angle between the rows and the driving force (rad).
  double tilt() const { return rotated_square() ? std::atan(epsilon()) : 0.0; }
  double epsilon() const { return row_shift_um / pitch_across_um(); }
  /// The pillar in either form.
  PillarValues pillar_values() const {
    return pillar ? *pillar : PillarValues{pillar_shape, {{"radius_um", {pillar_radius_um}}}};
  }
};

struct FluidParameters {
  double lattice_spacing_um = 0.4;     ///< dx
  std::string precision = "single";    ///< "single" | "double"
  std::string collision = "trt";       ///< "bgk" | "trt"
  double magic_parameter = 0.1875;     ///< Lambda of TRT
  std::string equilibrium = "stokes";  ///< "full" | "stokes" (quadratic terms dropped)
  std::string walls = "interpolated";  ///< pillar surface: "half_way" | "interpolated" | "central_linear"
  double relaxation_time = 0.8;        ///< tau of the suspending fluid; nu = (tau - 1/2) / 3
  double force_density = 2.2464e-4;    ///< along x, lattice units at lattice_spacing_um
  std::string lateral_flow = "free";   ///< "free" | "blocked" (mean u_y held at zero)
};

struct StartParameters {
  double x_um = -16.0;            ///< centre, relative to the pillar centres of row 0; absent: -pitch_um / 2
  double gap_position_um = -1.0;  ///< centre above the surface of the pillar below; < 0: chosen
  double z_um = 0.0;              ///< offset from the mid plane (full height only)
  double tilt_deg = 0.0;          ///< rotation about y (full height only)
};

struct CellParameters {
  std::string shape = "red_blood_cell";       ///< "red_blood_cell" | "sphere" | "ellipsoid" | "mesh"
  double radius_um = 3.9;                     ///< r (largest radius, in the plane)
  int mesh_frequency = 10;                    ///< 20 n^2 faces
  double capillary_number = 0.5;              ///< Ca = p' l r / kS, l = sqrt(G H)
  double skalak_denominator = 12.0;           ///< k in W = (kS/k)(I1^2 + 2 I1 - 2 I2) + (kalpha/12) I2^2
  double bending_ratio = 2.4810e-3;           ///< kB / (kS r^2)
  std::string bending_law = "hinge_half";     ///< what energy kB stands for, see membrane/bending_law.hpp
  double local_area_modulus = 28.876;         ///< kalpha / (p' l r)
  double global_area_modulus = 57.752;        ///< kA / (p' l r)
  std::string volume_control = "projection";  ///< "projection" | "penalty"
  double volume_modulus = 563.08;             ///< kV r / (p' l r), used by "penalty"
  double viscosity_ratio = 5.0;               ///< inside / outside
  std::string viscosity_field = "sharp";      ///< "sharp" | "smoothed"
  int viscosity_update_interval = 5;          ///< membrane updates from one inside/outside field to the next
  StartParameters start;
  std::vector<double> semi_axes_um;            ///< of the ellipsoid, along x, y, z; empty: absent
  std::string mesh_file;                       ///< of the mesh, relative to the case file; empty: absent
  std::shared_ptr<const CellSurface> surface;  ///< what the reader found in mesh_file
};

struct CouplingParameters {
  std::string kernel = "phi4";                ///< "phi2" | "phi3" | "phi4"
  std::string regularisation = "tangential";  ///< sub-grid mesh modes: "none" | "tangential"
  double regularisation_strength = 0.006;     ///< mobility of tangential force differences, times eta dx
  double pillar_repulsion = 2.815;            ///< K / (p' l dx^2), force K (1/h^2 - 1/h0^2)
  double wall_repulsion = 0.0;                ///< the same for the top and bottom walls; 0 switches it off
  double repulsion_range = 1.0;               ///< h0 in lattice spacings
  int steps_per_update = 2;                   ///< fluid steps for one update of the membrane
  double retraction = 0.0;  ///< lattice spacings by which the coupling points lie inside the membrane
};

struct StopParameters {
  std::string when = "decided";    ///< passage: "decided" (class proved) | "rows" (only at max_rows)
  int max_rows = 0;                ///< passage: 0 means ceil(1/epsilon) + 2 beyond the start transient
  double map_tolerance_um = 0.04;  ///< passage: extrapolated distance to the fixed point of the return map
  double steady_tolerance = 1e-8;  ///< streamlines, channel: relative change of the flow per 100 steps
  long max_steps = 4000000;        ///< a run that reaches this is labelled undecided
};

struct StretchingParameters {
  std::string method = "static";  ///< "static" (energy minimisation) | "coupled" (through the fluid)
  std::vector<double> forces_pN = {0, 20, 40, 60, 80, 100, 150, 200};
  double contact_radius_um = 1.0;       ///< 3D distance from the tip
  double shear_modulus_uN_per_m = 5.3;  ///< kS
};

struct ShearParameters {
  double capillary_number = 0.02;  ///< eta gdot a / kS' with kS' = kS (as printed in the energy)
  double reynolds_number = 0.05;   ///< gdot a^2 / nu
  double box_um = 32.0;            ///< cubic box: periodic in x, y; moving walls in z
  double duration = 4.0;           ///< in units of 1 / gdot
};

struct ChannelParameters {
  double width_um = 0.0;  ///< 0: plane channel of depth H; else a duct of width x depth
};

struct OutputParameters {
  bool flow_field = true;     ///< mid-plane velocity field
  int snapshots_per_row = 0;  ///< membrane snapshots besides those at the pillar lines
  int trajectory_samples_per_row = 50;
};

/// Operating conditions in SI units (operating.hpp): no defaults, a case may say nothing of them.
struct OperatingParameters {
  std::optional<double> pressure_gradient_Pa_per_m, pressure_drop_mbar, length_mm, mean_speed_um_per_s,
      flow_rate_uL_per_min, channel_width_um, shear_modulus_uN_per_m, viscosity_mPa_s;
};

struct Case {
  std::string scene = "passage";      ///< streamlines | stretching | passage | channel | shear
  std::string accuracy = "standard";  ///< preset whose settings replace the defaults below (presets.hpp)
  GeometryParameters geometry;
  FluidParameters fluid;
  CellParameters cell;
  CouplingParameters coupling;
  StopParameters stop;
  StretchingParameters stretching;
  ShearParameters shear;
  ChannelParameters channel;
  OutputParameters output;
  OperatingParameters operating;
  std::vector<std::string> warnings;  ///< of the reader: what was given without effect; not a parameter
};

}  // namespace dld
