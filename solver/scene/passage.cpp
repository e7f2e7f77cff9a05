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
#include <cmath>
#include <cstdio>
#include <iostream>

#include "coupling/coupled_cell.hpp"
#include "measure/cross_section.hpp"
#include "measure/return_map.hpp"
#include "parameters/consistency.hpp"
#include "parameters/flow_estimate.hpp"
#include "parameters/physical.hpp"
#include "parameters/text.hpp"
#include "parameters/work.hpp"
#include "scene/coupled_state.hpp"
#include "scene/device_output.hpp"
#include "scene/flow_output.hpp"
#include "scene/monitor.hpp"
#include "scene/passage_record.hpp"
#include "scene/passage_start.hpp"
#include "scene/pillar_output.hpp"
#include "scene/registry.hpp"
#include "scene/separations.hpp"
#include "scene/setup.hpp"
#include "scene/steady_flow.hpp"

namespace dld {
namespace {

template <class Real>
class PassageRun {
 public:
  PassageRun(const Case& c, RunContext& context)
      : case_(c),
        context_(context),
        l_(to_lattice(c)),
        device_(device_lu(c)),
        gap_(device_.gap_line()),
        lattice_(make_unit_cell(c, device_), make_fluid_model(c)),
        membrane_(cell_mesh(c.cell, l_.cell_radius), make_moduli(c, l_)),
        lateral_(c.fluid.lateral_flow == "blocked", l_, lateral_friction(c)),
        map_(map_options(c)),
        unit_(whole_steps(make_coupling_model(c))) {
    lattice_.set_uniform_force(l_.force_density * l_.drive[0], l_.force_density * l_.drive[1], 0.0);
    lattice_.set_threads(context.threads);
  }

  Status run() {
    load_checkpoint();
    if (saved_) {
      place_cell(membrane_.reference().vertices);
      resume();
    } else if (const auto ended = start()) {
      return *ended;
    }
    const double interval = std::min(0.2 / mean_velocity_, static_cast<double>(longest_interval));
    sample_interval_ = std::max(unit_, static_cast<int>(interval) / unit_ * unit_);
    context_.progress.start("passage", total_rows());
    const Status status = advance();
    context_.progress.finish(to_string(status));
    return status == Status::interrupted ? status : finish(status);
  }

 private:
  /// The steady flow and the cell at its start; the status of a run that ends here.
  std::optional<Status> start() {
    const SteadyState steady =
        run_to_steady_state(lattice_, lateral_, std::max(1e-6, case_.stop.steady_tolerance),
                            case_.stop.max_steps, context_.progress);
    if (steady.status == Status::interrupted) return steady.status;
    flow_steps_ = steady.steps;
    mean_velocity_ = lateral_.along(steady.flow.velocity);
    mean_across_ = lateral_.across(steady.flow.velocity);
    if (steady.status == Status::diverged) {
      failure_ = check_fluid(lattice_, steady.flow, l_.um_per_lu);
      return finish(Status::diverged);
    }
    if (steady.status != Status::converged) {
      reason_ = "the flow without the cell is not steady after " + std::to_string(steady.steps) +
                " steps (/stop/max_steps): it still changes by " + number_text(steady.residual) +
                " per 100 steps";
      return finish(Status::undecided);
    }
    const PlaneField field =
        mid_plane(lattice_, [this](double x, double y) { return device_.pillars().signed_distance(x, y); });
    place_cell(start_positions(case_, membrane_.reference().vertices, device_, field));
    if (has_separations()) separations_ = separations(field.flow(gap_, device_.tilt()));
    cell_->refresh_viscosity();
    save_checkpoint();  // a state to go back to, should the run fail before the first line
    return std::nullopt;
  }

  void place_cell(const Eigen::MatrixX3d& positions) {
    cell_.emplace(lattice_, membrane_, device_.pillars(), make_coupling_model(case_), positions);
  }

  bool has_separations() const { return !device_.empty() && case_.geometry.row_shift_um != 0; }

  /// Steps between checks, at the most: trouble is seen within a few hundred steps.
  static constexpr int longest_interval = 200;
  /// Distances from here on (lu) mean that there is no pillar or no wall.
  static constexpr double no_film = 1e300;
  double film_um(double film) const { return film < no_film ? film * l_.um_per_lu : NAN; }

  static ReturnMapOptions map_options(const Case& c) {
    ReturnMapOptions options;
    options.epsilon = c.geometry.epsilon();
    options.tolerance = c.stop.map_tolerance_um / c.fluid.lattice_spacing_um;
    options.max_rows = c.stop.max_rows;
    return options;
  }

  /// x of the gap line of the row that comes next, lattice units.
  double line_of_row() const { return gap_.x + static_cast<double>(row_) * l_.nx; }

  Status advance() {
    while (true) {
      if (steps_ >= case_.stop.max_steps) return Status::undecided;
      cell_->step();
      ++steps_;
      if (steps_ % sample_interval_ == 0) {
        sample();
        if (failure_) return Status::diverged;
        if (decided_ && extent_done_) return decided_status();
      }
      if (steps_ % longest_interval == 0) {
        watch_fluid();
        if (failure_) return Status::diverged;
      }
      if (lateral_.blocked() && steps_ % LateralFlow::interval == 0) {
        lateral_.update(lattice_, lattice_.statistics().velocity);
      }
      if (steps_ % unit_ != 0) continue;
      const bool stop = interrupted() != 0;
      if (row_finished_) cell_->refresh_viscosity();
      if (row_finished_ || stop || context_.save_timer.due()) save_checkpoint();
      if (stop) return Status::interrupted;
    }
  }

  Status decided_status() const {
    switch (map_.trajectory_class()) {
      case TrajectoryClass::displaced:
        return Status::displaced;
      case TrajectoryClass::zigzag:
        return Status::zigzag;
      default:
        return Status::undecided;
    }
  }

  /// Checks the fluid, and holds its mean density.
  void watch_fluid() {
    const FlowStatistics flow = lattice_.statistics();
    if (steps_ % 1000 == 0) lattice_.shift_density(-flow.mean_density_deviation);
    double& variation = record_.extremes.density_variation;
    variation = std::max(variation, flow.max_density_deviation - flow.min_density_deviation);
    failure_ = check_fluid(lattice_, flow, l_.um_per_lu);
  }

  CellView view(const MembraneState& state) const {
    CellView view = view_of(*cell_, membrane_, state, l_.um_per_lu);
    view.film = cell_->film();
    view.pillars = &device_.pillars();
    return view;
  }

  /// Measures cell and membrane, follows the passage of the current pillar line.
  void sample() {
    const Eigen::MatrixX3d& x = cell_->positions();
    const MembraneState state = membrane_.measure(x);
    failure_ = check_membrane(view(state));
    record_.extremes.update(state, membrane_, cell_->max_speed(), cell_->film(),
                            smallest_wall_gap(x, 0.5 * l_.depth));
    if (failure_) return;
    last_good_ = {"last_good", row_, steps_, x};

    const Eigen::Vector3d centre = cell_->centre().transpose();
    record_trajectory(x, centre, state);
    extent_.update(x, membrane_.reference().faces, centre, cell_->film(), steps_);
    if (extent_.centre_passed() && !crossing_added_) {
      const TrajectoryClass now = add_crossing(extent_.y_at_centre());
      crossing_added_ = true;
      context_.progress.set_total(total_rows());
      decided_ = case_.stop.when == "rows" ? row_ >= map_.last_row() : now != TrajectoryClass::running;
    }
    if (extent_.passed()) finish_row(state);
    if (context_.progress.due()) {
      char text[80];
      if (map_.crossings().empty()) {
        std::snprintf(text, sizeof text, "on the way to the first pillar line, step %ld", steps_);
      } else {
        std::snprintf(text, sizeof text, "row %d, step %ld, centre %.2f um above the pillar", row_, steps_,
                      map_.crossings().back().gap_position * l_.um_per_lu);
      }
      context_.progress.update(centre.x() / l_.nx + 0.5, text);
    }
  }

  /// The centre at height y (lu) on the pillar line after those that it has crossed.
  TrajectoryClass add_crossing(double y) {
    const int row = static_cast<int>(heights_.size());
    heights_.push_back(y);
    return map_.add(crossing_at(y, row, l_.ny, l_.row_shift, gap_));
  }

  /// Rows at the most, 0 while they are not known.
  double total_rows() const { return heights_.empty() ? 0.0 : map_.last_row() + 1.5; }

  void record_trajectory(const Eigen::MatrixX3d& x, const Eigen::Vector3d& centre,
                         const MembraneState& state) {
    const double spacing = static_cast<double>(l_.nx) / case_.output.trajectory_samples_per_row;
    const double moved = std::hypot(centre.x() - last_recorded_.x(), centre.y() - last_recorded_.y());
    if (record_.trajectory.size() > 0 && moved < spacing) return;
    last_recorded_ = centre;
    const Eigen::RowVector3d extent = x.colwise().maxCoeff() - x.colwise().minCoeff();
    const double um = l_.um_per_lu;
    record_.trajectory.append(
        {static_cast<double>(steps_), centre.x() * um, centre.y() * um, centre.z() * um, extent.x() * um,
         extent.y() * um, extent.z() * um, state.area / membrane_.reference_area() - 1.0,
         state.volume / membrane_.reference_volume() - 1.0, state.min_face_ratio, film_um(cell_->film())});
    const int per_row = case_.output.snapshots_per_row;
    if (per_row == 0) return;
    const auto index = static_cast<long>(std::floor(centre.x() * per_row / l_.nx));
    if (index > last_snapshot_) {
      last_snapshot_ = index;
      record_.keep_snapshot("snapshot", row_, steps_, x);
    }
  }

  /// The cell is past the pillar line: one row of results, then the next line.
  void finish_row(const MembraneState& state) {
    const Crossing& crossing = map_.crossings().back();
    const double um = l_.um_per_lu;
    const double previous = record_.crossings.size() > 0 ? record_.crossings.column("step").back() : NAN;
    record_.crossings.append({static_cast<double>(row_), extent_.step_at_centre(), extent_.y_at_centre() * um,
                              crossing.gap_position * um, static_cast<double>(crossing.lane),
                              crossing.bump ? 1.0 : 0.0, extent_.max_width() * um,
                              extent_.width_at_centre() * um, film_um(extent_.min_film()),
                              state.min_face_ratio, extent_.height_at_max() * um,
                              l_.nx * um / (extent_.step_at_centre() - previous)});
    record_.keep_snapshot("crossing", row_, extent_.step_at_max(), extent_.vertices_at_max());
    extent_done_ = decided_;
    if (decided_) return;
    ++row_;
    extent_ = PassageExtent(line_of_row());
    crossing_added_ = false;
    row_finished_ = true;
  }

  /// Saved when all of a step is done, so that the run that resumes misses none of it. It may be any whole
  /// step, whenever the machine's clock or a signal asks for it: nothing here may change the run that goes
  /// on.
  void save_checkpoint() {
    row_finished_ = false;
    Checkpoint checkpoint(checkpoint_identity(case_));
    save_coupled(checkpoint, lattice_, *cell_);
    const auto whole = [&](const char* name, long value) {
      checkpoint.set(name, static_cast<std::int64_t>(value));
    };
    whole("flow_steps", flow_steps_);
    checkpoint.set("mean_velocity", mean_velocity_);
    checkpoint.set("mean_across", mean_across_);
    whole("row", row_);
    whole("crossing_added", crossing_added_ ? 1 : 0);
    whole("decided", decided_ ? 1 : 0);
    whole("last_snapshot", last_snapshot_);
    checkpoint.set("last_recorded", std::vector<double>(last_recorded_.data(), last_recorded_.data() + 3));
    checkpoint.set("heights", heights_);
    if (separations_) save_separations(checkpoint, *separations_);
    checkpoint.set("extent", extent_.numbers());
    checkpoint.set("extent_vertices", to_values(extent_.vertices_at_max()));
    whole("last_good_row", last_good_.row);
    whole("last_good_step", last_good_.step);
    checkpoint.set("last_good_vertices", to_values(last_good_.vertices));
    record_.save(checkpoint);
    checkpoint.save(context_.checkpoint);
    context_.owns_checkpoint = true;
    context_.save_timer.restart();
  }

  /// Read before anything is simulated, so that a checkpoint that does not fit is known at once. Builds of
  /// the same commit can still differ in the layout of their arrays.
  void load_checkpoint() {
    if (!context_.resume) return;
    saved_ = Checkpoint::load(context_.checkpoint, checkpoint_identity(case_), std::cerr);
    if (!saved_) return;
    if (!coupled_fits(*saved_, lattice_, membrane_.vertex_count()))
      throw CheckpointMismatch(context_.checkpoint);
    context_.owns_checkpoint = true;
  }

  void resume() {
    const auto values = [&](const char* name) -> const auto& {
      return saved_->get<std::vector<double>>(name);
    };
    steps_ = restore_coupled(*saved_, lattice_, *cell_);
    flow_steps_ = saved_->integer("flow_steps");
    mean_velocity_ = values("mean_velocity").at(0);
    mean_across_ = values("mean_across").at(0);
    row_ = static_cast<int>(saved_->integer("row"));
    crossing_added_ = saved_->integer("crossing_added") != 0;
    decided_ = saved_->integer("decided") != 0;
    last_snapshot_ = saved_->integer("last_snapshot");
    last_recorded_ = to_matrix(values("last_recorded")).row(0).transpose();
    for (const double y : values("heights")) add_crossing(y);
    if (has_separations()) separations_ = load_separations(*saved_);
    extent_ = PassageExtent::from(values("extent"), to_matrix(values("extent_vertices")));
    last_good_ = {"last_good", static_cast<int>(saved_->integer("last_good_row")),
                  saved_->integer("last_good_step"), to_matrix(values("last_good_vertices"))};
    record_.load(*saved_);
    saved_.reset();
  }

  Status finish(Status status) {
    if (failure_ && last_good_.vertices.size() > 0) record_.keep(last_good_);
    if (!failure_ && cell_) record_.keep({"final", row_, steps_, cell_->positions()});
    summarise(status);
    const PhysicalScales scales = physical_scales(case_);
    context_.xdmf.series = record_.write(context_.out, membrane_, device_.pillars(), scales);
    write_surroundings();
    if (case_.output.flow_field && lattice_.even()) {
      Eigen::Vector2d centre = Eigen::Vector2d::Zero();
      if (cell_) centre = cell_->centre().head(2).transpose();
      write_plane_flow(context_, mid_plane(lattice_, {}), scales,
                       centre.allFinite() ? centre : Eigen::Vector2d::Zero());
    }
    return status;
  }

  /// The pillars that the cell has passed, and the streamlines that its way is judged by.
  void write_surroundings() {
    std::vector<double> x = record_.trajectory.column("x_um"), y = record_.trajectory.column("y_um");
    for (auto* way : {&x, &y}) {
      for (double& place : *way) place /= l_.um_per_lu;
    }
    const PillarArray& pillars = device_.pillars();
    write_pillars(context_, pillars, pillars_along(pillars, x, y), 0.5 * l_.depth, l_.um_per_lu);
    if (separations_) write_separations(context_, *separations_, l_.um_per_lu);
  }

  void summarise(Status status) {
    nlohmann::ordered_json& s = context_.summary;
    const double um = l_.um_per_lu;
    s["row_shift_um"] = case_.geometry.row_shift_um;
    s["epsilon"] = case_.geometry.epsilon();
    s["dx_um"] = um;
    write_device(context_, device_, um);
    s["capillary_number"] = case_.cell.capillary_number;
    s["skalak_denominator"] = case_.cell.skalak_denominator;
    s["bending_law"] = case_.cell.bending_law;
    s["fold_modulus_N_m"] = fold_modulus_N_m(case_);
    s["lateral_flow"] = case_.fluid.lateral_flow;
    s["class"] = to_string(status);
    if (!reason_.empty()) s["reason"] = reason_;
    const int defining = map_.defining_crossing();
    const bool known = defining >= 0 && static_cast<std::size_t>(defining) < record_.crossings.size();
    const auto value = [&](const char* column) -> nlohmann::ordered_json {
      if (!known) return nullptr;
      return record_.crossings.column(column)[static_cast<std::size_t>(defining)];
    };
    s["defining_crossing"] = defining;
    s["d_perp_um"] = value("d_perp_um");
    s["d_perp_at_centre_um"] = value("d_perp_at_centre_um");
    s["centre_um"] = value("gap_position_um");
    s["film_um"] = value("film_um");
    s["height_um"] = value("height_um");
    s["speed_um_per_step"] = value("speed_um_per_step");
    const MapBracket bracket = map_.bracket();
    s["map_limit_um"] = bracket.limit * um;
    s["map_ratio"] = bracket.ratio;
    const auto length = [um](double x) {
      return std::isnan(x) ? nlohmann::ordered_json() : nlohmann::ordered_json(x * um);
    };
    s["map_step_um"] = bracket.step * um;
    s["map_lowest_bump_um"] = length(bracket.lowest_bump);
    s["map_highest_zig_um"] = length(bracket.highest_zig);
    s["crossings"] = record_.crossings.size();
    s["zigs"] = map_.zigs();
    s["area_change"] = record_.extremes.area_change;
    s["volume_change"] = record_.extremes.volume_change;
    s["max_local_area_strain"] = record_.extremes.local_area_strain;
    s["min_face_ratio"] = record_.extremes.min_face_ratio;
    const auto distance = [um](double d) { return d < no_film ? nlohmann::ordered_json(d * um) : nullptr; };
    s["smallest_film_um"] = distance(record_.extremes.film);
    s["smallest_wall_gap_um"] = distance(record_.extremes.wall_gap);
    s["max_speed"] = record_.extremes.speed;
    s["density_variation"] = record_.extremes.density_variation;
    s["regularisation_mobility"] = cell_ ? cell_->mobility() : 0.0;
    s["odd_columns"] = cell_ ? cell_->odd_columns() : 0;
    s["steps"] = steps_ + flow_steps_;
    s["node_updates"] = (steps_ + flow_steps_) * static_cast<long>(lattice_.fluid_nodes());
    s["membrane_updates"] = steps_ * membrane_.vertex_count();
    s["memory_bytes"] = lattice_.memory_bytes();
    const SiScales si = to_si(case_);
    s["si"] = {{"pressure_gradient_bar_per_m", si.pressure_gradient_Pa_per_m * 1e-5},
               {"mean_velocity_mm_per_s", mean_velocity_ * si.velocity_m_per_s_per_lu * 1e3}};
    summarise_mean_flow(case_, mean_velocity_, mean_across_, s);
    if (!failure_) return;
    report_failure(*failure_, cell_ ? steps_ : flow_steps_, s);
    if (last_good_.vertices.size() > 0) s["last_good_step"] = last_good_.step;
  }

  const Case& case_;
  RunContext& context_;
  LatticeParameters l_;
  Device device_;
  GapLine gap_;
  Lattice<Real> lattice_;
  Membrane membrane_;
  LateralFlow lateral_;
  std::optional<CoupledCell<Real>> cell_;
  ReturnMap map_;
  int unit_;                     ///< steps after which fluid and cell are both whole
  std::vector<double> heights_;  ///< y of the centre (lu) at the crossings of map_

  std::optional<Separations>
      separations_;  ///< none in an empty slit, without a row shift and before the flow
  PassageRecord record_;
  PassageExtent extent_{gap_.x};
  std::optional<Checkpoint> saved_;  ///< what the run goes on from; empty once it does
  std::optional<Failure> failure_;
  std::string reason_;          ///< why the run ended before a cell was in it
  MembraneSnapshot last_good_;  ///< shape at the last sample that passed all checks
  Eigen::Vector3d last_recorded_ = Eigen::Vector3d::Zero();
  double mean_velocity_ = 0, mean_across_ = 0;  ///< of the flow without the cell, along and across the force
  long steps_ = 0, flow_steps_ = 0, last_snapshot_ = -1000000;
  int row_ = 0, sample_interval_ = 2;
  bool row_finished_ = false;  ///< the state is to be saved at the end of this step
  bool crossing_added_ = false, decided_ = false, extent_done_ = false;
};

Status run_passage(const Case& c, RunContext& context) {
  return with_precision(c, [&]<class Real>() { return PassageRun<Real>(c, context).run(); });
}

}  // namespace

Scene passage_scene() {
  return {{.name = "passage",
           .sections = {"geometry", "fluid", "cell", "coupling", "stop", "output"},
           .check = check_passage,
           .margins = passage_margins,
           .work = passage_work,
           .box = passage_box},
          run_passage};
}

}  // namespace dld
