/// Scene `streamlines`: the cell-free flow through the array.
///
///   -grad p + eta laplace u + f e_x = 0,  div u = 0   (Stokes; with inertia if the case says so)
///   u = 0 on the pillars and at z = +- H/2,  u(x + lambda, y) = u(x, y - d)
///   in a rotated square array d = 0 and the force is turned by -atan(epsilon) from the rows, the x axis
///
/// 1 run to the steady state   2 flow resistance and mean velocities   3 separation streamlines, s
///
/// Try: dld run params/cases/streamlines.json /tmp/streamlines.h5
#include "parameters/consistency.hpp"
#include "parameters/flow_estimate.hpp"
#include "parameters/physical.hpp"
#include "parameters/work.hpp"
#include "scene/device_output.hpp"
#include "scene/flow_output.hpp"
#include "scene/monitor.hpp"
#include "scene/pillar_output.hpp"
#include "scene/registry.hpp"
#include "scene/separations.hpp"
#include "scene/setup.hpp"
#include "scene/steady_flow.hpp"

namespace dld {
namespace {

void summarise_flow(const Case& c, const SteadyState& steady, const LateralFlow& lateral, double porosity,
                    nlohmann::ordered_json& summary) {
  const LatticeParameters l = to_lattice(c);
  const SiScales si = to_si(c);
  const double u = lateral.along(steady.flow.velocity);
  const double slit = l.force_density * l.depth * l.depth / (12.0 * l.viscosity);
  const auto reynolds = [&](double velocity) { return velocity * l.length_scale / l.viscosity; };
  summary["mean_velocity"] = u;
  summary["superficial_velocity"] = u * porosity;
  summary["lateral_velocity_ratio"] = lateral.across(steady.flow.velocity) / u;
  summary["resistance_Pa_s_per_m2"] = l.force_density / u * si.resistance_Pa_s_per_m2_per_lu;
  summary["reynolds_number"] = reynolds(u);
  summary["reynolds_number_superficial"] = reynolds(u * porosity);
  summary["reynolds_number_slit"] = reynolds(slit);
  summary["max_speed"] = steady.flow.max_speed;
  summary["density_variation"] = steady.flow.max_density_deviation - steady.flow.min_density_deviation;
  summary["residual"] = steady.residual;
  summarise_mean_flow(c, u, lateral.across(steady.flow.velocity), summary);
}

template <class Real>
Status run(const Case& c, RunContext& context) {
  const LatticeParameters l = to_lattice(c);
  const Device device = device_lu(c);
  const PillarArray& pillars = device.pillars();
  const UnitCell cell = make_unit_cell(c, device);
  Lattice<Real> lattice(cell, make_fluid_model(c));
  lattice.set_threads(context.threads);
  lattice.set_uniform_force(l.force_density * l.drive[0], l.force_density * l.drive[1], 0.0);

  const LateralFlow lateral(c.fluid.lateral_flow == "blocked", l, lateral_friction(c));
  const SteadyState steady =
      run_to_steady_state(lattice, lateral, c.stop.steady_tolerance, c.stop.max_steps, context.progress);
  if (steady.status == Status::interrupted) return steady.status;
  nlohmann::ordered_json& summary = context.summary;
  summary["row_shift_um"] = c.geometry.row_shift_um;
  summary["epsilon"] = c.geometry.epsilon();
  summary["dx_um"] = c.fluid.lattice_spacing_um;
  write_device(context, device, l.um_per_lu);
  summary["steps"] = steady.steps;
  summary["node_updates"] = steady.steps * static_cast<long>(lattice.fluid_nodes());
  summary["membrane_updates"] = 0;
  summary["memory_bytes"] = lattice.memory_bytes();
  summary["lateral_force_ratio"] = lateral.across(lattice.uniform_force()) / l.force_density;
  const double porosity =
      static_cast<double>(lattice.fluid_nodes()) / (static_cast<double>(l.nx) * l.ny * l.nz);
  summarise_flow(c, steady, lateral, porosity, summary);
  if (steady.status == Status::diverged) {
    if (const auto failure = check_fluid(lattice, steady.flow, l.um_per_lu))
      report_failure(*failure, steady.steps, summary);
    return steady.status;
  }

  const PlaneField field =
      mid_plane(lattice, [&pillars](double x, double y) { return pillars.signed_distance(x, y); });
  if (c.output.flow_field) write_plane_flow(context, field, physical_scales(c));
  if (pillars.empty()) return steady.status;
  write_pillars(context, pillars, {{-1, 0}, {-1, 1}, {0, 0}, {0, 1}, {1, 0}, {1, 1}}, 0.5 * l.depth,
                l.um_per_lu);
  if (c.geometry.row_shift_um != 0)
    write_separations(context, separations(field.flow(device.gap_line(), device.tilt())), l.um_per_lu);
  return steady.status;
}

Status run_streamlines(const Case& c, RunContext& context) {
  return with_precision(c, [&]<class Real>() { return run<Real>(c, context); });
}

}  // namespace

Scene streamlines_scene() {
  return {{.name = "streamlines",
           .sections = {"geometry", "fluid", "stop", "output"},
           .check = check_streamlines,
           .margins = streamlines_margins,
           .work = streamlines_work,
           .box = streamlines_box},
          run_streamlines};
}

}  // namespace dld
