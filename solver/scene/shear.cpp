/// Scene `shear`: a spherical capsule in plane Couette flow, for validation.
///
///   walls at z = +- H/2 move with -+ gdot H/2; small deformation (Barthes-Biesel 1980; Barthes-Biesel, Diaz
///   and Dhenin 2002): D = (5/8) eta gdot a (3/Gs + 1/Ks), Gs = 4 kS/k, Ks = Gs + 2 kalpha/3,
///   independent of the viscosity ratio. kalpha = local_area_modulus * kS here, since there is no p' l r.
///
/// Try: dld run params/cases/shear.json /tmp/shear.h5
#include <cmath>

#include "coupling/coupled_cell.hpp"
#include "measure/deformation.hpp"
#include "output/interrupt.hpp"
#include "scene/monitor.hpp"
#include "scene/passage_record.hpp"
#include "scene/registry.hpp"
#include "scene/setup.hpp"

namespace dld {
namespace {

UnitCell shear_box(int n) {
  UnitCell cell;
  cell.nx = cell.ny = cell.nz = n;
  cell.height = HeightBoundary::walls;
  cell.origin_x = cell.origin_y = cell.origin_z = 0.5 - 0.5 * n;
  mark_solid(cell, true);
  return cell;
}

template <class Real>
Status run(const Case& c, RunContext& context) {
  const LatticeParameters l = scene_lattice(c);
  const double a = l.cell_radius, rate = l.shear_rate;
  const int n = l.nx;
  const double wall_speed = 0.5 * rate * n;

  FluidModel fluid = make_fluid_model(c);
  fluid.wall_motion = {-wall_speed, wall_speed};
  const UnitCell box = shear_box(n);
  Lattice<Real> lattice(box, fluid);
  lattice.set_threads(context.threads);
  lattice.initialise([&](int, int, int z) {
    return std::array<double, 3>{rate * (z + box.origin_z), 0.0, 0.0};
  });

  const MembraneModuli moduli = make_moduli(c, l);
  Membrane membrane(make_cell(c.cell.shape, c.cell.mesh_frequency, a), moduli);
  const PillarArray no_pillars(make_pillar("none", {}), n, n, 0.0);
  CouplingModel coupling = make_coupling_model(c);
  coupling.wall_height = 0.5 * n;  // the walls are those of the box
  CoupledCell<Real> cell(lattice, membrane, no_pillars, coupling, membrane.reference().vertices);

  ColumnTable series({{"time", "1/gdot", "time times shear rate", {}},
                      {"deformation", "none", "(L - B)/(L + B) of the equivalent ellipsoid", {}},
                      {"volume_change", "none", "(V - V0)/V0", {}}});
  const long steps = std::lround(c.shear.duration / rate);
  const long interval = std::max(2L, steps / 200 / 2 * 2);
  double deformation = 0.0;
  Status status = Status::converged;
  context.progress.start("shear", static_cast<double>(steps));
  long step = 1;
  for (; step <= steps; ++step) {
    cell.step();
    if (step % interval != 0) continue;
    const MembraneState state = membrane.measure(cell.positions());
    deformation = taylor_deformation(equivalent_semi_axes(cell.positions(), membrane.reference().faces));
    series.append(
        {static_cast<double>(step) * rate, deformation, state.volume / membrane.reference_volume() - 1.0});
    const CellView view{.membrane = membrane,
                        .positions = cell.positions(),
                        .velocities = cell.velocities(),
                        .state = state,
                        .speed = cell.max_speed(),
                        .um_per_lu = l.um_per_lu};
    if (const auto failure = check_membrane(view)) {
      report_failure(*failure, step, context.summary);
      status = Status::diverged;
      break;
    }
    if (interrupted() != 0) {
      status = Status::interrupted;
      break;
    }
    if (context.progress.due()) context.progress.update(static_cast<double>(step), "");
  }
  context.progress.finish(to_string(status));
  const double gs = 4.0 * moduli.shear / moduli.skalak_denominator, ks = gs + 2.0 * moduli.local_area / 3.0;
  context.summary["deformation"] = deformation;
  context.summary["deformation_theory"] = 0.625 * l.viscosity * rate * a * (3.0 / gs + 1.0 / ks);
  const long done = std::min(step, steps);
  context.summary["steps"] = done;
  context.summary["node_updates"] = done * static_cast<long>(lattice.fluid_nodes());
  context.summary["membrane_updates"] = done * membrane.vertex_count();
  if (series.size() > 0) {
    const PhysicalScales scales = physical_scales(c);
    series.write(context.out, "/shear", scales);
    context.out.physical("/shear/time", "s", scales.time_step_s / rate);
  }
  return status;
}

}  // namespace

Status run_shear(const Case& c, RunContext& context) {
  return with_precision(c, [&]<class Real>() { return run<Real>(c, context); });
}

}  // namespace dld
