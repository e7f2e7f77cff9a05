#include "parameters/declaration.hpp"

#include <algorithm>

#include "geometry/pillar.hpp"
#include "membrane/bending_law.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/presets.hpp"
#include "parameters/scene_rules.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

// Address of a nested member: at<&Case::cell, &CellParameters::start, &StartParameters::x_um>.
template <auto... members>
Field at(Case& c) {
  return &(c.*....*members);
}

using G = GeometryParameters;
using F = FluidParameters;
using L = CellParameters;
using S = StartParameters;
using U = CouplingParameters;
using P = StopParameters;
using T = StretchingParameters;
using H = ShearParameters;
using W = ChannelParameters;
using O = OutputParameters;

Allowed between(double minimum, double maximum) {
  return {minimum, maximum};
}
Allowed above(double minimum, double maximum) {
  return {minimum, maximum, true};
}
Allowed one_of(std::vector<std::string> names, std::string meaning = {}) {
  return {.names = std::move(names), .meaning = std::move(meaning)};
}
Allowed any() {
  return {};
}
Allowed three(Allowed of_each) {
  of_each.items = 3;
  return of_each;
}

std::vector<Declaration> geometry_and_fluid() {
  return {
      {"", "scene", at<&Case::scene>, one_of(scene_names()), "", "what is simulated"},
      {"", "accuracy", at<&Case::accuracy>, one_of(preset_names(), preset_purposes()), "",
       "numerical settings that take the place of the defaults; keys that are given stay"},
      {"geometry", "pillar_shape", at<&Case::geometry, &G::pillar_shape>, one_of({"circle", "none"}), "",
       "cross-section of the pillars; none for an empty slit; other shapes are given as pillar"},
      {"geometry", "pillar_radius_um", at<&Case::geometry, &G::pillar_radius_um>, above(0, 1000), "um",
       "R, radius of the circle about the pillar"},
      {"geometry", "pillar", at<&Case::geometry, &G::pillar>, any(), "",
       "cross-section of the pillars in place of pillar_shape and pillar_radius_um: a shape and its "
       "parameters, about the pillar's centre"},
      {"geometry", "pitch_um", at<&Case::geometry, &G::pitch_um>, above(0, 5000), "um",
       "lambda, distance of neighbouring pillar centres along x, and along y unless pitch_y_um is given"},
      {"geometry", "pitch_y_um", at<&Case::geometry, &G::pitch_y_um>, above(0, 5000), "um",
       "distance of neighbouring pillar centres along y, across the flow; absent: pitch_um"},
      {"geometry", "row_shift_um", at<&Case::geometry, &G::row_shift_um>, between(0, 5000), "um",
       "d, lateral shift of each row against the one before; or give epsilon"},
      {"geometry", "layout", at<&Case::geometry, &G::layout>, one_of({"row_shifted", "rotated_square"}), "",
       "how the pillars stand: rows shifted against each other, or an unshifted square array that is driven "
       "at "
       "the angle atan(epsilon) to its rows; absent: row_shifted"},
      {"geometry", "depth_um", at<&Case::geometry, &G::depth_um>, above(0, 1000), "um",
       "H, between the bottom and the top wall"},
      {"geometry", "pillar_center", at<&Case::geometry, &G::pillar_center>, one_of({"node", "between_nodes"}),
       "", "where the pillar centre sits on the lattice, in x and y"},
      {"geometry", "surface_nodes", at<&Case::geometry, &G::surface_nodes>, one_of({"solid", "fluid"}), "",
       "what a node exactly on the pillar surface is"},
      {"geometry", "height", at<&Case::geometry, &G::height>, one_of({"half", "full"}), "",
       "half simulates z > 0 only, with a mirror plane at z = 0"},
      {"fluid", "lattice_spacing_um", at<&Case::fluid, &F::lattice_spacing_um>, above(0, 100), "um",
       "dx, spacing of the fluid nodes"},
      {"fluid", "precision", at<&Case::fluid, &F::precision>, one_of({"single", "double"}), "",
       "of the fluid populations; the membrane is always double"},
      {"fluid", "collision", at<&Case::fluid, &F::collision>, one_of({"bgk", "trt"}), "",
       "one relaxation time, or two with a magic parameter"},
      {"fluid", "magic_parameter", at<&Case::fluid, &F::magic_parameter>, above(0, 100), "1",
       "Lambda = (tau+ - 1/2)(tau- - 1/2) of trt"},
      {"fluid", "equilibrium", at<&Case::fluid, &F::equilibrium>, one_of({"full", "stokes"}), "",
       "stokes drops the quadratic terms and with them the inertia"},
      {"fluid", "walls", at<&Case::fluid, &F::walls>, one_of({"half_way", "interpolated", "central_linear"}),
       "", "bounce-back at the pillar: staircase, or at the true distance along each link"},
      {"fluid", "relaxation_time", at<&Case::fluid, &F::relaxation_time>, above(0.5, 100), "1",
       "tau of the suspending fluid; viscosity (tau - 1/2) / 3 in lattice units"},
      {"fluid", "force_density", at<&Case::fluid, &F::force_density>, between(1e-12, 1), "lu",
       "driving force per volume along x, in units of the given lattice"},
      {"fluid", "lateral_flow", at<&Case::fluid, &F::lateral_flow>, one_of({"free", "blocked"}), "",
       "blocked holds the mean lateral velocity at zero, as side walls do"},
  };
}

std::vector<Declaration> cell() {
  return {
      {"cell", "shape", at<&Case::cell, &L::shape>, one_of(all_cell_shape_names()), "", "stress-free shape"},
      {"cell", "radius_um", at<&Case::cell, &L::radius_um>, above(0, 1000), "um",
       "r, largest radius; of an ellipsoid or a mesh only the scale in Ca and the moduli, by default the "
       "largest "
       "radius in the plane"},
      {"cell", "semi_axes_um", at<&Case::cell, &L::semi_axes_um>, three(above(0, 1000)), "um",
       "of the shape ellipsoid, along x, y and z"},
      {"cell", "mesh_file", at<&Case::cell, &L::mesh_file>, any(), "",
       "of the shape mesh: closed surface of triangles in um, OFF or STL, relative to the case file"},
      {"cell", "mesh_frequency", at<&Case::cell, &L::mesh_frequency>, between(1, 200), "1",
       "n of the subdivided icosahedron; 20 n^2 faces"},
      {"cell", "capillary_number", at<&Case::cell, &L::capillary_number>, between(1e-6, 1e4), "1",
       "Ca = p' l r / kS with l = sqrt(G H), G = pitch - 2 R"},
      {"cell", "skalak_denominator", at<&Case::cell, &L::skalak_denominator>, above(0, 1000), "1",
       "k in W = (kS/k)(I1^2 + 2 I1 - 2 I2) + (kalpha/12) I2^2"},
      {"cell", "bending_ratio", at<&Case::cell, &L::bending_ratio>, between(0, 1000), "1", "kB / (kS r^2)"},
      {"cell", "bending_law", at<&Case::cell, &L::bending_law>, one_of(bending_law_names()), "",
       "what energy kB stands for: a sum over hinges with c = sqrt(3), sqrt(3)/2 or 1/sqrt(3), or the nodal "
       "mean "
       "curvature; a fold feels 3, 1.5, 1 or 1 kB"},
      {"cell", "local_area_modulus", at<&Case::cell, &L::local_area_modulus>, between(0, 1e9), "p' l r",
       "kalpha"},
      {"cell", "global_area_modulus", at<&Case::cell, &L::global_area_modulus>, between(0, 1e9), "p' l r",
       "kA"},
      {"cell", "volume_control", at<&Case::cell, &L::volume_control>, one_of({"projection", "penalty"}), "",
       "how the volume is held"},
      {"cell", "volume_modulus", at<&Case::cell, &L::volume_modulus>, between(0, 1e9), "p' l",
       "kV, used by volume_control penalty"},
      {"cell", "viscosity_ratio", at<&Case::cell, &L::viscosity_ratio>, above(0, 1000), "1",
       "inside / outside"},
      {"cell", "viscosity_field", at<&Case::cell, &L::viscosity_field>, one_of({"sharp", "smoothed"}), "",
       "transition of the viscosity across the membrane"},
      {"cell", "viscosity_update_interval", at<&Case::cell, &L::viscosity_update_interval>,
       between(1, 100000), "updates", "of the membrane from one inside/outside field to the next"},
      {"cell/start", "x_um", at<&Case::cell, &L::start, &S::x_um>, between(-1e5, 0), "um",
       "centre along x, relative to the pillar centres of row 0, before the line on which the gap is "
       "narrowest; when it is not given half a pitch before them, -16 for the default pitch"},
      {"cell/start", "gap_position_um", at<&Case::cell, &L::start, &S::gap_position_um>, between(-5000, 5000),
       "um",
       "centre above the surface of the pillar below; a negative value leaves the choice to the solver"},
      {"cell/start", "z_um", at<&Case::cell, &L::start, &S::z_um>, between(-1000, 1000), "um",
       "centre above the mid plane (full height only)"},
      {"cell/start", "tilt_deg", at<&Case::cell, &L::start, &S::tilt_deg>, between(-180, 180), "degrees",
       "rotation about y (full height only)"},
  };
}

std::vector<Declaration> coupling_and_stop() {
  return {
      {"coupling", "kernel", at<&Case::coupling, &U::kernel>,
       one_of({"phi2", "phi3", "phi4", "phi4_corrected"}), "",
       "immersed-boundary kernel of 2, 3 or 4 points; phi4_corrected gives back what it takes from the "
       "velocity in a fluid of the mean viscosity"},
      {"coupling", "regularisation", at<&Case::coupling, &U::regularisation>, one_of({"none", "tangential"}),
       "", "cure of mesh modes below the lattice spacing"},
      {"coupling", "regularisation_strength", at<&Case::coupling, &U::regularisation_strength>,
       between(0, 100), "1 / (eta dx)", "share of the nodal force difference turned into velocity"},
      {"coupling", "pillar_repulsion", at<&Case::coupling, &U::pillar_repulsion>, between(0, 1e9),
       "p' l dx^2", "K of the force K (1/h^2 - 1/h0^2), h in lattice spacings"},
      {"coupling", "wall_repulsion", at<&Case::coupling, &U::wall_repulsion>, between(0, 1e9), "p' l dx^2",
       "the same for the bottom and the top wall; 0 switches it off"},
      {"coupling", "repulsion_range", at<&Case::coupling, &U::repulsion_range>, above(0, 100), "dx", "h0"},
      {"coupling", "steps_per_update", at<&Case::coupling, &U::steps_per_update>, between(1, 64), "1",
       "fluid steps for one update of the membrane"},
      {"coupling", "retraction", at<&Case::coupling, &U::retraction>, between(0, 2), "dx",
       "distance of the coupling points inside the membrane, against the kernel's thickness"},
      {"stop", "when", at<&Case::stop, &P::when>, one_of({"decided", "rows"}), "",
       "passage: as soon as the class is proved, or only after max_rows"},
      {"stop", "max_rows", at<&Case::stop, &P::max_rows>, between(0, 1000000), "rows",
       "passage: 0 means ceil(1/epsilon) + 2 beyond the start transient"},
      {"stop", "map_tolerance_um", at<&Case::stop, &P::map_tolerance_um>, above(0, 100), "um",
       "passage: extrapolated distance to the fixed point of the return map"},
      {"stop", "steady_tolerance", at<&Case::stop, &P::steady_tolerance>, above(0, 1), "1",
       "streamlines, channel: relative change of the flow per 100 steps"},
      {"stop", "max_steps", at<&Case::stop, &P::max_steps>, between(1, 1e12), "steps",
       "a run that reaches it is labelled undecided"},
  };
}

std::vector<Declaration> other_scenes() {
  return {
      {"stretching", "method", at<&Case::stretching, &T::method>, one_of({"static", "coupled"}), "",
       "energy minimisation, or relaxation in the fluid"},
      {"stretching", "forces_pN", at<&Case::stretching, &T::forces_pN>, between(0, 1e6), "pN",
       "pull on each of the two ends"},
      {"stretching", "contact_radius_um", at<&Case::stretching, &T::contact_radius_um>, above(0, 1000), "um",
       "nodes within this distance of a tip are pulled"},
      {"stretching", "shear_modulus_uN_per_m", at<&Case::stretching, &T::shear_modulus_uN_per_m>,
       above(0, 1e9), "uN/m", "kS"},
      {"shear", "capillary_number", at<&Case::shear, &H::capillary_number>, between(1e-6, 1e3), "1",
       "eta gdot a / kS, a the radius of the capsule"},
      {"shear", "reynolds_number", at<&Case::shear, &H::reynolds_number>, between(1e-6, 1000), "1",
       "gdot a^2 / nu"},
      {"shear", "box_um", at<&Case::shear, &H::box_um>, above(0, 5000), "um",
       "edge of the cubic box: periodic in x and y, moving walls in z"},
      {"shear", "duration", at<&Case::shear, &H::duration>, above(0, 1e6), "1 / gdot", "simulated time"},
      {"channel", "width_um", at<&Case::channel, &W::width_um>, between(0, 5000), "um",
       "0 is a plane channel of the depth; else a duct of width x depth"},
      {"output", "flow_field", at<&Case::output, &O::flow_field>, any(), "", "write the mid-plane velocity"},
      {"output", "snapshots_per_row", at<&Case::output, &O::snapshots_per_row>, between(0, 10000), "1",
       "membrane snapshots besides those at the pillar lines"},
      {"output", "trajectory_samples_per_row", at<&Case::output, &O::trajectory_samples_per_row>,
       between(1, 100000), "1", "samples of the trajectory"},
  };
}

}  // namespace

std::string Declaration::pointer() const {
  return (section.empty() ? "/" : "/" + std::string(section) + "/") + std::string(name);
}

const std::vector<Declaration>& declarations() {
  static const std::vector<Declaration> table = [] {
    auto all = geometry_and_fluid();
    for (const auto& part : {cell(), coupling_and_stop(), other_scenes()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

const Declaration& epsilon_declaration() {
  static const Declaration epsilon{"geometry",    "epsilon", nullptr,
                                   between(0, 1), "1",       "d / pitch along y, instead of row_shift_um"};
  return epsilon;
}

std::vector<std::string> sections() {
  std::vector<std::string> names;
  for (const auto& declaration : declarations()) {
    const std::string section(declaration.section);
    if (!section.empty() && std::ranges::find(names, section) == names.end()) names.push_back(section);
  }
  return names;
}

bool in_range(double value, const Allowed& allowed) {
  return value <= allowed.maximum &&
         (allowed.open_minimum ? value > allowed.minimum : value >= allowed.minimum);
}

std::string nearest_advice(double value, const Allowed& allowed) {
  if (value > allowed.maximum) return "use at most " + number_text(allowed.maximum);
  return (allowed.open_minimum ? "use more than " : "use at least ") + number_text(allowed.minimum);
}

std::string allowed_text(const Allowed& allowed) {
  if (!allowed.names.empty()) return "one of " + joined(allowed.names);
  std::string text;
  const bool low = allowed.minimum > -std::numeric_limits<double>::infinity();
  const bool high = allowed.maximum < std::numeric_limits<double>::infinity();
  if (low) text += (allowed.open_minimum ? "above " : "at least ") + number_text(allowed.minimum);
  if (high) text += (low ? " and at most " : "at most ") + number_text(allowed.maximum);
  return text.empty() ? "any" : text;
}

}  // namespace dld
