/// Scene `stretching`: the optical tweezer. Two opposite forces F act on patches at the two ends of the cell.
///
///   static   the shape at rest minimises E(x) - F (x_right - x_left); no fluid, since at rest there is none
///   coupled  the same forces on a cell in a quiescent fluid, stepped until it rests: a check of the coupling
///
/// The area and volume moduli are the case's, times kS (there is no p' l r here): kalpha = local_area_modulus
/// kS.
///
/// Try: dld run params/cases/stretching.json /tmp/stretching.h5
#include "membrane/stretching.hpp"

#include <cmath>
#include <cstdio>

#include "coupling/coupled_cell.hpp"
#include "geometry/no_pillar.hpp"
#include "output/interrupt.hpp"
#include "parameters/consistency.hpp"
#include "parameters/text.hpp"
#include "parameters/work.hpp"
#include "scene/coupled_state.hpp"
#include "scene/membrane_output.hpp"
#include "scene/monitor.hpp"
#include "scene/registry.hpp"
#include "scene/setup.hpp"

namespace dld {
namespace {

/// One row of the result: shape in um, extents, and how it was reached.
struct Result {
  double force_pN = 0;
  Eigen::MatrixX3d vertices_um;
  double axial_um = 0, transverse_um = 0, energy_J = 0;
  long iterations = 0;
};

void save_results(const std::vector<Result>& results, Checkpoint& state) {
  state.set("results", static_cast<std::int64_t>(results.size()));
  for (std::size_t k = 0; k < results.size(); ++k) {
    const Result& r = results[k];
    const std::string name = "result_" + std::to_string(k);
    state.set(name, std::vector<double>{r.force_pN, r.axial_um, r.transverse_um, r.energy_J,
                                        static_cast<double>(r.iterations)});
    state.set(name + "_vertices", to_values(r.vertices_um));
  }
}

std::vector<Result> load_results(const Checkpoint& state) {
  std::vector<Result> results;
  for (std::int64_t k = 0; k < state.integer("results"); ++k) {
    const std::string name = "result_" + std::to_string(k);
    const auto& n = state.get<std::vector<double>>(name);
    results.push_back({n.at(0), to_matrix(state.get<std::vector<double>>(name + "_vertices")), n.at(1),
                       n.at(2), n.at(3), static_cast<long>(n.at(4))});
  }
  return results;
}

std::vector<Result> stretch_static(const Case& c, Membrane& membrane, RunContext& context, Status& status) {
  const ContactPatches patches(membrane.reference().vertices, c.stretching.contact_radius_um);
  const std::string identity = checkpoint_identity(c);
  std::vector<Result> results;
  if (const auto saved = context.resume ? Checkpoint::load(context.checkpoint, identity, std::cerr)
                                        : std::optional<Checkpoint>()) {
    results = load_results(*saved);
    if (saved->integer("undecided") != 0) status = Status::undecided;
    context.owns_checkpoint = true;
  }
  MinimiserOptions options;
  options.stop = [] { return interrupted() != 0; };
  context.progress.start("stretching", static_cast<double>(c.stretching.forces_pN.size()));
  while (results.size() < c.stretching.forces_pN.size()) {
    const double force_pN = c.stretching.forces_pN[results.size()];
    const Eigen::MatrixX3d start =
        results.empty() ? membrane.reference().vertices : results.back().vertices_um;
    const StretchedShape shape = stretch(membrane, patches, force_pN, start, options);
    if (!shape.stopped) {
      results.push_back(
          {force_pN, shape.vertices, shape.axial, shape.transverse, shape.energy * 1e-18, shape.iterations});
      if (!shape.converged) status = Status::undecided;
    }
    if (context.progress.due())
      context.progress.update(static_cast<double>(results.size()), short_number(force_pN) + " pN");
    if (!shape.stopped && !context.save_timer.due()) continue;
    Checkpoint checkpoint(identity);
    save_results(results, checkpoint);
    checkpoint.set("undecided", std::int64_t{status == Status::undecided ? 1 : 0});
    checkpoint.save(context.checkpoint);
    context.owns_checkpoint = true;
    context.save_timer.restart();
    if (!shape.stopped) continue;
    status = Status::interrupted;
    break;
  }
  context.progress.finish(to_string(status));
  return results;
}

/// Box around the stretched cell: periodic along the pull and across it, mirror plane and one far wall.
UnitCell quiescent_box(const LatticeParameters& l) {
  UnitCell cell;
  cell.nx = l.nx;
  cell.ny = l.ny;
  cell.nz = l.nz;
  cell.height = HeightBoundary::mirror_and_wall;
  cell.origin_x = 0.5 - 0.5 * cell.nx;
  cell.origin_y = 0.5 - 0.5 * cell.ny;
  cell.origin_z = 0.5;
  mark_solid(cell, true);
  return cell;
}

template <class Real>
std::vector<Result> stretch_coupled(const Case& c, RunContext& context, Status& status) {
  const LatticeParameters l = scene_lattice(c);
  constexpr double shear_lu = coupled_stretching_shear_modulus;
  Lattice<Real> lattice(quiescent_box(l), make_fluid_model(c));
  lattice.set_threads(context.threads);
  Membrane membrane(cell_mesh(c.cell, l.cell_radius), make_moduli(c, l));
  const PillarArray no_pillars(std::make_shared<const NoPillar>(), lattice.cell().nx, lattice.cell().ny, 0.0);
  CouplingModel coupling = make_coupling_model(c);
  coupling.wall_height = lattice.cell().nz;  // the far wall; the mirror plane is z = 0
  CoupledCell<Real> cell(lattice, membrane, no_pillars, coupling, membrane.reference().vertices);
  const ContactPatches patches(membrane.reference().vertices, c.stretching.contact_radius_um / l.um_per_lu);
  cell.external_forces = Eigen::MatrixX3d::Zero(membrane.vertex_count(), 3);

  constexpr int interval = 500;
  constexpr double rest = 2e-5;  // relative change of the extents per interval
  const auto extent = [&](int axis) {
    return cell.positions().col(axis).maxCoeff() - cell.positions().col(axis).minCoeff();
  };
  std::vector<Result> results;
  long steps = 0, begin = 0;
  double axial = 0.0, transverse = 0.0;
  CoupledCheckpoint<Real> checkpoints(c, context, lattice, membrane.vertex_count());
  const auto add = [&](Checkpoint& state) {
    state.set("begin", static_cast<std::int64_t>(begin));
    state.set("extents", std::vector<double>{axial, transverse});
    save_results(results, state);
  };
  if (const auto saved = checkpoints.load()) {
    steps = checkpoints.restore(*saved, cell);
    begin = saved->integer("begin");
    const auto& extents = saved->template get<std::vector<double>>("extents");
    axial = extents.at(0);
    transverse = extents.at(1);
    results = load_results(*saved);
  }
  context.progress.start("stretching through the fluid", static_cast<double>(c.stretching.forces_pN.size()));
  while (results.size() < c.stretching.forces_pN.size()) {
    const double force_pN = c.stretching.forces_pN[results.size()];
    // F / kS is a length: the same in both systems of units.
    const double force = force_pN / c.stretching.shear_modulus_uN_per_m / l.um_per_lu * shear_lu;
    cell.external_forces.setZero();
    patches.add_pull(force, cell.external_forces);
    while (true) {
      if (checkpoints.stop(steps, cell, add)) {
        status = Status::interrupted;
        break;
      }
      cell.step();
      ++steps;
      if (steps % interval != 0) continue;
      const MembraneState state = membrane.measure(cell.positions());
      if (const auto failure = check_membrane(view_of(cell, membrane, state, l.um_per_lu))) {
        report_failure(*failure, steps, context.summary);
        status = Status::diverged;
        break;
      }
      const double a = extent(0), t = extent(1);
      const bool resting = std::abs(a - axial) < rest * a && std::abs(t - transverse) < rest * t;
      axial = a;
      transverse = t;
      if (resting) break;
      if (steps >= c.stop.max_steps) status = Status::undecided;
      if (status != Status::converged) break;
      if (context.progress.due()) {
        context.progress.update(static_cast<double>(results.size()), short_number(force_pN) + " pN");
      }
    }
    // Energy scales with kS dx^2: from lattice units to J.
    const double joule = c.stretching.shear_modulus_uN_per_m / shear_lu * l.um_per_lu * l.um_per_lu * 1e-18;
    results.push_back({force_pN, cell.positions() * l.um_per_lu, axial * l.um_per_lu,
                       transverse * l.um_per_lu, membrane.energy(cell.positions()) * joule, steps - begin});
    if (status != Status::converged) break;
    axial = transverse = 0.0;
    begin = steps;
  }
  context.progress.finish(to_string(status));
  context.summary["node_updates"] = steps * static_cast<long>(lattice.fluid_nodes());
  return results;
}

/// `membrane` in um and pN, so that its tensions are in uN/m.
void write_results(const Case& c, const Membrane& membrane, const std::vector<Result>& results,
                   RunContext& context) {
  std::vector<double> force, axial, transverse, energy;
  std::vector<std::int64_t> iterations;
  MembraneOutput shapes(context.out, membrane, {.um = 1, .tension_uN_m = 1, .basis = {}});
  for (const Result& r : results) {
    char name[24];
    std::snprintf(name, sizeof name, "force_%03d", static_cast<int>(force.size()));
    const std::string group = shapes.write(name, r.vertices_um, r.force_pN, "shape at rest");
    context.out.attribute(group, "force_pN", r.force_pN);
    force.push_back(r.force_pN);
    axial.push_back(r.axial_um);
    transverse.push_back(r.transverse_um);
    energy.push_back(r.energy_J);
    iterations.push_back(r.iterations);
  }
  context.xdmf.series = shapes.series();
  context.out.write("/stretching/force_pN", force, "pN", "force on each end");
  context.out.write("/stretching/axial_um", axial, "um", "extent along the pull");
  context.out.write("/stretching/transverse_um", transverse, "um",
                    "extent across the pull, in the cell's plane");
  context.out.write("/stretching/energy_J", energy, "J", "elastic energy of the membrane");
  context.out.write("/stretching/iterations", iterations, "none",
                    "iterations of the minimiser, or time steps");
  nlohmann::ordered_json& s = context.summary;
  s["skalak_denominator"] = c.cell.skalak_denominator;
  s["bending_law"] = c.cell.bending_law;
  s["mesh_frequency"] = c.cell.mesh_frequency;
  s["method"] = c.stretching.method;
  s["dx_um"] = c.fluid.lattice_spacing_um;
  s["force_pN"] = force;
  s["axial_um"] = axial;
  s["transverse_um"] = transverse;
  long total = 0;
  for (const auto n : iterations) total += n;
  s["steps"] = total;
  if (!s.contains("node_updates")) s["node_updates"] = 0;
  s["membrane_updates"] = total * membrane.vertex_count();
}

Status run_stretching(const Case& c, RunContext& context) {
  Status status = Status::converged;
  // um and pN: 1 uN/m = 1 pN/um.
  Case at_rest = c;
  at_rest.stretching.method = "static";
  const LatticeParameters l = scene_lattice(at_rest);
  MembraneModuli moduli = make_moduli(c, l);
  moduli.volume = l.volume_modulus;  // nothing else keeps the volume of a shape at rest
  Membrane membrane(cell_mesh(c.cell, c.cell.radius_um), moduli);
  std::vector<Result> results;
  if (c.stretching.method == "coupled") {
    results = with_precision(c, [&]<class Real>() { return stretch_coupled<Real>(c, context, status); });
  } else {
    results = stretch_static(c, membrane, context, status);
  }
  if (status == Status::interrupted) return status;
  write_results(c, membrane, results, context);
  return status;
}

}  // namespace

Scene stretching_scene() {
  return {{.name = "stretching",
           .sections = {"geometry", "fluid", "cell", "coupling", "stop", "stretching", "output"},
           .check = check_stretching,
           .margins = [](const Case& c) { return stretching_margins(c, kink_mobility(c)); },
           .work = stretching_work,
           .box = stretching_box},
          run_stretching};
}

}  // namespace dld
