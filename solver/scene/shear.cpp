/// Scene `shear`: a spherical capsule in plane Couette flow, for validation.
///
///   walls at z = +- H/2 move with -+ gdot H/2; small deformation (Barthes-Biesel 1980; Barthes-Biesel, Diaz
///   and Dhenin 2002): D = (5/8) eta gdot a (3/Gs + 1/Ks), Gs = 4 kS/k, Ks = Gs + 2 kalpha/3,
///   independent of the viscosity ratio. kalpha = local_area_modulus * kS here, since there is no p' l r.
///
/// Try: dld run params/cases/shear.json /tmp/shear.h5
#include <cmath>

#include "coupling/coupled_cell.hpp"
#include "geometry/no_pillar.hpp"
#include "measure/deformation.hpp"
#include "output/interrupt.hpp"
#include "parameters/consistency.hpp"
#include "parameters/work.hpp"
#include "scene/coupled_state.hpp"
#include "scene/monitor.hpp"
#include "scene/passage_record.hpp"
#include "scene/registry.hpp"
#include "scene/setup.hpp"

namespace dld {
namespace {

UnitCell shear_cell(int n) {
  UnitCell cell;
  cell.nx = cell.ny = cell.nz = n;
  cell.height = HeightBoundary::walls;
  cell.origin_x = cell.origin_y = cell.origin_z = 0.5 - 0.5 * n;
  mark_solid(cell, true);
  return cell;
}

/// Steps between two looks at the cell, at the most.
constexpr long longest_watch = 200;

/// A deformation that changes by less in the last quarter of the time is called steady. One that nears its
/// limit as 1 - exp(-t/T) is then within 0.4 % of it.
constexpr double steady_change = 0.01;

/// The quarter must shear the fluid by this much: in less time a cell that is deformed at rest (the
/// discocyte) keeps its shape whatever becomes of it.
constexpr double least_strain = 0.5;

/// Relative change over the last quarter of a series; infinite for a series too short to tell.
double change_of_last_quarter(const std::vector<double>& values) {
  constexpr std::size_t fewest = 20;
  if (values.size() < fewest) return HUGE_VAL;
  const double last = values.back(), before = values[values.size() - 1 - values.size() / 4];
  return std::abs(last - before) / std::max(std::abs(last), 1e-300);
}

template <class Real>
Status run(const Case& c, RunContext& context) {
  const LatticeParameters l = scene_lattice(c);
  const double a = l.cell_radius, rate = l.shear_rate;
  const int n = l.nx;
  const double wall_speed = 0.5 * rate * n;

  FluidModel fluid = make_fluid_model(c);
  fluid.wall_motion = {-wall_speed, wall_speed};
  const UnitCell box = shear_cell(n);
  Lattice<Real> lattice(box, fluid);
  lattice.set_threads(context.threads);
  lattice.initialise([&](int, int, int z) {
    return std::array<double, 3>{rate * (z + box.origin_z), 0.0, 0.0};
  });

  const MembraneModuli moduli = make_moduli(c, l);
  Membrane membrane(cell_mesh(c.cell, a), moduli);
  const PillarArray no_pillars(std::make_shared<const NoPillar>(), n, n, 0.0);
  CouplingModel coupling = make_coupling_model(c);
  coupling.wall_height = 0.5 * n;  // the walls are those of the box
  CoupledCell<Real> cell(lattice, membrane, no_pillars, coupling, membrane.reference().vertices);

  ColumnTable series({{"time", "1/gdot", "time times shear rate", {}},
                      {"deformation", "none", "(L - B)/(L + B) of the equivalent ellipsoid", {}},
                      {"volume_change", "none", "(V - V0)/V0", {}}});
  const long steps = std::lround(c.shear.duration / rate), last = std::min(steps, c.stop.max_steps);
  const long interval = std::max(2L, steps / 200 / 2 * 2);
  long done = 0;
  CoupledCheckpoint<Real> checkpoints(c, context, lattice, membrane.vertex_count());
  if (const auto saved = checkpoints.load()) {
    done = checkpoints.restore(*saved, cell);
    series.load(*saved, "series_");
  }
  Status status = Status::undecided;
  context.progress.start("shear", static_cast<double>(last));
  while (done < last && status == Status::undecided) {
    cell.step();
    ++done;
    if (done % interval == 0) {
      series.append({static_cast<double>(done) * rate,
                     taylor_deformation(equivalent_semi_axes(cell.positions(), membrane.reference().faces)),
                     membrane.measure(cell.positions()).volume / membrane.reference_volume() - 1.0});
    }
    if (done % interval == 0 || done % longest_watch == 0) {
      const MembraneState state = membrane.measure(cell.positions());
      if (const auto failure = check_membrane(view_of(cell, membrane, state, l.um_per_lu))) {
        report_failure(*failure, done, context.summary);
        status = Status::diverged;
      }
      if (context.progress.due()) context.progress.update(static_cast<double>(done), "");
    }
    if (status == Status::undecided &&
        checkpoints.stop(done, cell, [&](Checkpoint& state) { series.save(state, "series_"); }))
      status = Status::interrupted;
  }
  const double change = change_of_last_quarter(series.column("deformation"));
  const bool long_enough = 0.25 * c.shear.duration >= least_strain;
  if (status == Status::undecided && done == steps && long_enough && change < steady_change)
    status = Status::converged;
  context.progress.finish(to_string(status));
  const double deformation = series.size() > 0 ? series.column("deformation").back() : 0.0;
  const double gs = 4.0 * moduli.shear / moduli.skalak_denominator, ks = gs + 2.0 * moduli.local_area / 3.0;
  context.summary["deformation"] = deformation;
  context.summary["deformation_change"] = std::isfinite(change) ? nlohmann::ordered_json(change) : nullptr;
  if (sized_by_radius(c.cell))  // the theory is that of a sphere
    context.summary["deformation_theory"] = 0.625 * l.viscosity * rate * a * (3.0 / gs + 1.0 / ks);
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

Status run_shear(const Case& c, RunContext& context) {
  return with_precision(c, [&]<class Real>() { return run<Real>(c, context); });
}

}  // namespace

Scene shear_scene() {
  return {{.name = "shear",
           .sections = {"fluid", "cell", "coupling", "stop", "shear", "output"},
           .check = check_shear,
           .margins = shear_margins,
           .work = shear_work,
           .box = shear_box},
          run_shear};
}

}  // namespace dld
