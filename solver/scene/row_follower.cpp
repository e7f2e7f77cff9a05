#include "scene/row_follower.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace dld {
namespace {

double film_um(double film, double um_per_lu) {
  return film < no_distance ? film * um_per_lu : NAN;
}

}  // namespace

void RowFollower::sample(const CellView& cell, const Eigen::Vector3d& centre) {
  state_.last_good = {"last_good", state_.row, state_.steps, cell.positions};
  record_trajectory(cell, centre);
  state_.extent.update(cell.positions, cell.membrane.reference().faces, centre, cell.film, state_.steps);
  if (state_.extent.centre_passed() && !state_.crossing_added) cross_line();
  if (state_.extent.passed()) finish_row(cell.state);
}

bool RowFollower::row_passed() {
  return std::exchange(row_passed_, false);
}

double RowFollower::total_rows() const {
  return state_.map().crossings().empty() ? 0.0 : state_.map().last_row() + 1.5;
}

std::string RowFollower::place_text() const {
  char text[80];
  if (state_.map().crossings().empty()) {
    std::snprintf(text, sizeof text, "on the way to the first pillar line, step %ld", state_.steps);
  } else {
    std::snprintf(text, sizeof text, "row %d, step %ld, centre %.2f um above the pillar", state_.row,
                  state_.steps, state_.map().crossings().back().gap_position * l_.um_per_lu);
  }
  return text;
}

/// A sample of the trajectory, and a shape, where the cell has moved on by enough since the last one.
void RowFollower::record_trajectory(const CellView& cell, const Eigen::Vector3d& centre) {
  PassageRecord& record = state_.record;
  const double spacing = static_cast<double>(l_.nx) / case_.output.trajectory_samples_per_row;
  const double moved =
      std::hypot(centre.x() - state_.last_recorded.x(), centre.y() - state_.last_recorded.y());
  if (record.trajectory.size() > 0 && moved < spacing) return;
  state_.last_recorded = centre;
  const Eigen::MatrixX3d& x = cell.positions;
  const Eigen::RowVector3d extent = x.colwise().maxCoeff() - x.colwise().minCoeff();
  const double um = l_.um_per_lu;
  record.trajectory.append({static_cast<double>(state_.steps), centre.x() * um, centre.y() * um,
                            centre.z() * um, extent.x() * um, extent.y() * um, extent.z() * um,
                            cell.state.area / cell.membrane.reference_area() - 1.0,
                            cell.state.volume / cell.membrane.reference_volume() - 1.0,
                            cell.state.min_face_ratio, film_um(cell.film, um)});
  const int per_row = case_.output.snapshots_per_row;
  if (per_row == 0) return;
  const auto index = static_cast<long>(std::floor(centre.x() * per_row / l_.nx));
  if (index > state_.last_snapshot) {
    state_.last_snapshot = index;
    record.keep_snapshot("snapshot", state_.row, state_.steps, x);
  }
}

/// The centre is past the pillar line: one more point of the return map.
void RowFollower::cross_line() {
  const TrajectoryClass now = state_.add_crossing(state_.extent.y_at_centre());
  state_.crossing_added = true;
  state_.decided =
      case_.stop.when == "rows" ? state_.row >= state_.map().last_row() : now != TrajectoryClass::running;
}

/// All of the cell is past the pillar line: one row of results, then the next line.
void RowFollower::finish_row(const MembraneState& membrane) {
  const Crossing& crossing = state_.map().crossings().back();
  const PassageExtent& extent = state_.extent;
  ColumnTable& crossings = state_.record.crossings;
  const double um = l_.um_per_lu;
  const double previous = crossings.size() > 0 ? crossings.column("step").back() : NAN;
  crossings.append({static_cast<double>(state_.row), extent.step_at_centre(), extent.y_at_centre() * um,
                    crossing.gap_position * um, static_cast<double>(crossing.lane), crossing.bump ? 1.0 : 0.0,
                    extent.max_width() * um, extent.width_at_centre() * um, film_um(extent.min_film(), um),
                    membrane.min_face_ratio, extent.height_at_max() * um,
                    l_.nx * um / (extent.step_at_centre() - previous)});
  state_.record.keep_snapshot("crossing", state_.row, extent.step_at_max(), extent.vertices_at_max());
  finished_ = state_.decided;
  if (finished_) return;
  ++state_.row;
  state_.extent = PassageExtent(state_.line_of_row());
  state_.crossing_added = false;
  row_passed_ = true;
}

}  // namespace dld
