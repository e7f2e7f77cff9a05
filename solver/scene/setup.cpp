#include "scene/setup.hpp"

namespace dld {

UnitCell make_unit_cell(const Case& c, const Device& device) {
  const LatticeParameters l = to_lattice(c);
  UnitCell cell;
  cell.nx = l.nx;
  cell.ny = l.ny;
  cell.nz = l.nz;
  cell.row_shift = l.row_shift;
  cell.height = l.half_height ? HeightBoundary::mirror_and_wall : HeightBoundary::walls;
  // The pillar's centre is on node (nx/2, ny/2), or half a spacing before it.
  const double offset = c.geometry.pillar_center == "between_nodes" ? 0.5 : 0.0;
  cell.origin_x = offset - l.nx / 2;
  cell.origin_y = offset - l.ny / 2;
  // The mid plane is z = 0; walls and the mirror plane lie half way between layers.
  cell.origin_z = l.half_height ? 0.5 : 0.5 - 0.5 * l.nz;
  cell.distance = [&pillars = device.pillars()](double x, double y, double) {
    return pillars.signed_distance(x, y);
  };
  mark_solid(cell, c.geometry.surface_nodes == "solid");
  return cell;
}

FluidModel make_fluid_model(const Case& c) {
  FluidModel model;
  model.collision = c.fluid.collision == "bgk" ? CollisionModel::bgk : CollisionModel::trt;
  model.equilibrium = c.fluid.equilibrium == "full" ? EquilibriumModel::full : EquilibriumModel::stokes;
  model.walls = c.fluid.walls == "half_way"       ? WallModel::half_way
                : c.fluid.walls == "interpolated" ? WallModel::interpolated
                                                  : WallModel::central_linear;
  model.magic_parameter = c.fluid.magic_parameter;
  model.relaxation_time = c.fluid.relaxation_time;
  return model;
}

MembraneModuli make_moduli(const Case& c, const LatticeParameters& l) {
  MembraneModuli m;
  m.shear = l.shear_modulus;
  m.skalak_denominator = c.cell.skalak_denominator;
  m.local_area = l.local_area_modulus;
  m.global_area = l.global_area_modulus;
  m.volume = c.cell.volume_control == "penalty" ? l.volume_modulus : 0.0;
  m.bending = l.bending_modulus;
  m.bending_law = bending_law_by_name(c.cell.bending_law);
  return m;
}

double kink_mobility(const Case& c) {
  const double odd = c.fluid.relaxation_time - 0.5;
  const double magic = c.fluid.collision == "bgk" ? odd * odd : c.fluid.magic_parameter;
  return kernel_correction(c.coupling.kernel, c.cell.viscosity_ratio, magic) / to_lattice(c).viscosity;
}

CouplingModel make_coupling_model(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  CouplingModel model;
  model.kernel = kernel_by_name(c.coupling.kernel);
  model.kink_mobility = kink_mobility(c);
  model.mobility =
      c.coupling.regularisation == "tangential" ? c.coupling.regularisation_strength / l.viscosity : 0.0;
  model.steps_per_update = c.coupling.steps_per_update;
  model.retraction = c.coupling.retraction;
  model.project_volume = c.cell.volume_control == "projection";
  model.pillar_repulsion = {l.repulsion_strength, c.coupling.repulsion_range};
  model.wall_repulsion = {l.wall_repulsion_strength, c.coupling.repulsion_range};
  model.wall_height = 0.5 * l.depth;
  model.tau_outside = l.tau_outside;
  model.tau_inside = l.tau_inside;
  model.smoothed_viscosity = c.cell.viscosity_field == "smoothed";
  model.viscosity_update_interval = c.cell.viscosity_update_interval;
  return model;
}

}  // namespace dld
