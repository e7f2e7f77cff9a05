/// Scene `passage`: one deformable cell through the periodic, row-shifted array until its class is known.
///
///   fluid     D3Q19 lattice Boltzmann, driven by a force density along x, viscosity nu outside the cell and
///             viscosity_ratio * nu inside
///   membrane  Skalak, bending, area, volume; coupled by the immersed-boundary method
///   class     from the return map at the pillar lines x = n lambda: displaced, zigzag or undecided
///
/// 1 steady flow without the cell   2 start near the separation streamline   3 pass pillar lines until the
/// return map has proved the class   4 D_perp at the defining crossing
///
/// Try: dld run params/cases/passage.json /tmp/passage.h5
#include <algorithm>
#include <optional>
#include <vector>

#include "coupling/coupled_cell.hpp"
#include "parameters/consistency.hpp"
#include "parameters/flow_estimate.hpp"
#include "parameters/physical.hpp"
#include "parameters/text.hpp"
#include "parameters/work.hpp"
#include "scene/coupled_state.hpp"
#include "scene/flow_output.hpp"
#include "scene/lateral_flow.hpp"
#include "scene/monitor.hpp"
#include "scene/passage_start.hpp"
#include "scene/passage_state.hpp"
#include "scene/passage_summary.hpp"
#include "scene/pillar_output.hpp"
#include "scene/registry.hpp"
#include "scene/row_follower.hpp"
#include "scene/setup.hpp"
#include "scene/steady_flow.hpp"

namespace dld {
namespace {

/// Steps between checks, at the most: trouble is seen within a few hundred steps.
constexpr int longest_interval = 200;

Status status_of(TrajectoryClass trajectory) {
  switch (trajectory) {
    case TrajectoryClass::displaced:
      return Status::displaced;
    case TrajectoryClass::zigzag:
      return Status::zigzag;
    default:
      return Status::undecided;
  }
}

template <class Real>
class PassageRun {
 public:
  PassageRun(const Case& c, RunContext& context)
      : case_(c),
        context_(context),
        l_(to_lattice(c)),
        device_(device_lu(c)),
        lattice_(make_unit_cell(c, device_), make_fluid_model(c)),
        membrane_(cell_mesh(c.cell, l_.cell_radius), make_moduli(c, l_)),
        lateral_(c.fluid.lateral_flow == "blocked", l_, lateral_friction(c)),
        state_(c, device_),
        rows_(c, state_),
        checkpoints_(c, context, lattice_, membrane_.vertex_count()) {
    lattice_.set_uniform_force(l_.force_density * l_.drive[0], l_.force_density * l_.drive[1], 0.0);
    lattice_.set_threads(context.threads);
  }

  Status run() {
    if (const auto saved = checkpoints_.load()) {
      resume(*saved);
    } else {
      const Status flow = reach_steady_flow();
      if (flow == Status::interrupted) return flow;
      if (flow != Status::converged) return finish(flow);
      start();
    }
    const Status status = pass_lines();
    return status == Status::interrupted ? status : finish(status);
  }

 private:
  /// 1. The flow without the cell.
  Status reach_steady_flow() {
    const SteadyState steady =
        run_to_steady_state(lattice_, lateral_, std::max(1e-6, case_.stop.steady_tolerance),
                            case_.stop.max_steps, context_.progress);
    state_.flow.steps = steady.steps;
    state_.flow.along = lateral_.along(steady.flow.velocity);
    state_.flow.across = lateral_.across(steady.flow.velocity);
    if (steady.status == Status::diverged) {
      failure_ = check_fluid(lattice_, steady.flow, l_.um_per_lu);
    } else if (steady.status == Status::undecided) {
      reason_ = "the flow without the cell is not steady after " + std::to_string(steady.steps) +
                " steps (/stop/max_steps): it still changes by " + number_text(steady.residual) +
                " per 100 steps";
    }
    return steady.status;
  }

  /// 2. The cell at its start, as this flow tells where that is.
  void start() {
    const PlaneField field =
        mid_plane(lattice_, [this](double x, double y) { return device_.pillars().signed_distance(x, y); });
    place_cell(start_positions(case_, membrane_.reference().vertices, device_, field));
    if (state_.has_separations())
      state_.flow.separations = separations(field.flow(device_.gap_line(), device_.tilt()));
    cell_->refresh_viscosity();
    checkpoints_.save(*cell_, saving());  // to go back to, should the run fail before the first line
  }

  /// In place of 1 and 2: the state of a run that was stopped.
  void resume(const Checkpoint& saved) {
    place_cell(membrane_.reference().vertices);
    state_.steps = checkpoints_.restore(saved, *cell_);
    state_.load(saved);
  }

  /// 3. Passes pillar lines until the class is known, a check fails or the run is to stop. Nothing that the
  /// machine's clock or a signal decides may change the run that goes on.
  Status pass_lines() {
    context_.progress.start("passage", rows_.total_rows());
    const int interval = sample_interval();
    Status status = Status::undecided;
    while (status == Status::undecided && state_.steps < case_.stop.max_steps) {
      cell_->step();
      const long steps = ++state_.steps;
      if (steps % interval == 0) sample();
      if (rows_.finished()) break;
      if (!failure_ && steps % longest_interval == 0) watch_fluid();
      if (failure_) break;
      lateral_.after_step(lattice_, steps);
      if (!checkpoints_.whole(steps)) continue;
      const bool row_passed = rows_.row_passed();
      if (row_passed) cell_->refresh_viscosity();
      if (checkpoints_.stop(steps, *cell_, saving(), row_passed)) status = Status::interrupted;
    }
    if (failure_) status = Status::diverged;
    if (rows_.finished()) status = status_of(state_.map().trajectory_class());
    context_.progress.finish(to_string(status));
    return status;
  }

  /// 4. D_perp with all else that is measured, and the shapes and surroundings to look at.
  Status finish(Status status) {
    PassageRecord& record = state_.record;
    if (failure_ && state_.last_good.vertices.size() > 0) record.keep(state_.last_good);
    if (!failure_ && cell_) record.keep({"final", state_.row, state_.steps, cell_->positions()});
    summarise_passage(case_, device_, state_, {status, reason_, failure_}, size(), context_);
    const PhysicalScales scales = physical_scales(case_);
    context_.xdmf.series = record.write(context_.out, membrane_, device_.pillars(), scales);
    write_surroundings();
    if (case_.output.flow_field && lattice_.even()) {
      Eigen::Vector2d centre = Eigen::Vector2d::Zero();
      if (cell_) centre = cell_->centre().head(2).transpose();
      write_plane_flow(context_, mid_plane(lattice_, {}), scales,
                       centre.allFinite() ? centre : Eigen::Vector2d::Zero());
    }
    return status;
  }

  void place_cell(const Eigen::MatrixX3d& positions) {
    cell_.emplace(lattice_, membrane_, device_.pillars(), make_coupling_model(case_), positions);
  }

  auto saving() const {
    return [this](Checkpoint& checkpoint) { state_.save(checkpoint); };
  }

  /// Whole steps in which the flow goes on by a fifth of a lattice spacing.
  int sample_interval() const {
    const double interval = std::min(0.2 / state_.flow.along, static_cast<double>(longest_interval));
    const int unit = whole_steps(make_coupling_model(case_));
    return std::max(unit, static_cast<int>(interval) / unit * unit);
  }

  /// Checks and measures the cell.
  void sample() {
    const MembraneState measured = membrane_.measure(cell_->positions());
    const CellView cell = view_of(*cell_, membrane_, measured, l_.um_per_lu, &device_.pillars());
    failure_ = check_membrane(cell);
    state_.record.extremes.update(cell, smallest_wall_gap(cell.positions, 0.5 * l_.depth));
    if (failure_) return;
    const Eigen::Vector3d centre = cell_->centre().transpose();
    rows_.sample(cell, centre);
    if (!context_.progress.due()) return;
    context_.progress.set_total(rows_.total_rows());
    context_.progress.update(centre.x() / l_.nx + 0.5, rows_.place_text());
  }

  /// Checks the fluid, and holds its mean density.
  void watch_fluid() {
    const FlowStatistics flow = lattice_.statistics();
    if (state_.steps % 1000 == 0) lattice_.shift_density(-flow.mean_density_deviation);
    double& variation = state_.record.extremes.density_variation;
    variation = std::max(variation, flow.max_density_deviation - flow.min_density_deviation);
    failure_ = check_fluid(lattice_, flow, l_.um_per_lu);
  }

  SimulatedSize size() const {
    return {.with_cell = cell_.has_value(),
            .fluid_nodes = static_cast<long>(lattice_.fluid_nodes()),
            .vertices = membrane_.vertex_count(),
            .memory_bytes = lattice_.memory_bytes(),
            .mobility = cell_ ? cell_->mobility() : 0.0,
            .odd_columns = cell_ ? cell_->odd_columns() : 0};
  }

  /// The pillars that the cell has passed, and the streamlines that its way is judged by.
  void write_surroundings() {
    const ColumnTable& trajectory = state_.record.trajectory;
    std::vector<double> x = trajectory.column("x_um"), y = trajectory.column("y_um");
    for (auto* way : {&x, &y}) {
      for (double& place : *way) place /= l_.um_per_lu;
    }
    const PillarArray& pillars = device_.pillars();
    write_pillars(context_, pillars, pillars_along(pillars, x, y), 0.5 * l_.depth, l_.um_per_lu);
    if (state_.flow.separations) write_separations(context_, *state_.flow.separations, l_.um_per_lu);
  }

  const Case& case_;
  RunContext& context_;
  LatticeParameters l_;
  Device device_;
  Lattice<Real> lattice_;
  Membrane membrane_;
  LateralFlow lateral_;
  std::optional<CoupledCell<Real>> cell_;  ///< once the flow without it is steady
  PassageState state_;
  RowFollower rows_;
  CoupledCheckpoint<Real> checkpoints_;
  std::optional<Failure> failure_;
  std::string reason_;  ///< why the run ended before a cell was in it
};

Status run_passage(const Case& c, RunContext& context) {
  return with_precision(c, [&]<class Real>() { return PassageRun<Real>(c, context).run(); });
}

}  // namespace

Scene passage_scene() {
  return {{.name = "passage",
           .sections = {"geometry", "fluid", "cell", "coupling", "stop", "output"},
           .check = check_passage,
           .margins = [](const Case& c) { return passage_margins(c, kink_mobility(c)); },
           .work = passage_work,
           .box = passage_box},
          run_passage};
}

}  // namespace dld
