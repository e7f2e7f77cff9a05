#include "scene/passage_record.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "scene/coupled_state.hpp"

namespace dld {

void ColumnTable::append(const std::vector<double>& row) {
  if (row.size() != columns_.size()) throw std::logic_error("a row has one value per column");
  for (std::size_t k = 0; k < row.size(); ++k) columns_[k].values.push_back(row[k]);
}

const std::vector<double>& ColumnTable::column(const std::string& name) const {
  for (const Column& column : columns_) {
    if (column.name == name) return column.values;
  }
  throw std::out_of_range("no column " + name);
}

void ColumnTable::write(Hdf5File& out, const std::string& group, const PhysicalScales& scales) const {
  for (const Column& column : columns_) {
    const std::string dataset = group + "/" + column.name;
    out.write(dataset, column.values, column.unit, column.description);
    if (column.unit == "step") out.physical(dataset, "s", scales.time_step_s);
    if (column.unit == "um/step" && scales.time_step_s > 0)
      out.physical(dataset, "mm/s", 1e-3 / scales.time_step_s);
  }
}

void ColumnTable::save(Checkpoint& checkpoint, const std::string& prefix) const {
  for (const Column& column : columns_) checkpoint.set(prefix + column.name, column.values);
}

void ColumnTable::load(const Checkpoint& checkpoint, const std::string& prefix) {
  for (Column& column : columns_) column.values = checkpoint.get<std::vector<double>>(prefix + column.name);
}

namespace {

ColumnTable trajectory_table() {
  return ColumnTable({
      {"step", "step", "time step", {}},
      {"x_um", "um", "centre, relative to the pillar of row 0, not wrapped", {}},
      {"y_um", "um", "centre, relative to the pillar of row 0, lane 0, not wrapped", {}},
      {"z_um", "um", "centre above the mid plane", {}},
      {"extent_x_um", "um", "extent of the cell along x", {}},
      {"extent_y_um", "um", "extent of the cell along y", {}},
      {"extent_z_um", "um", "extent of the cell along z", {}},
      {"area_change", "none", "(A - A0) / A0", {}},
      {"volume_change", "none", "(V - V0) / V0", {}},
      {"min_face_ratio", "none", "smallest area of a face relative to its reference", {}},
      {"film_um", "um", "smallest distance between the membrane and a pillar", {}},
  });
}

ColumnTable crossings_table() {
  return ColumnTable({
      {"row", "none", "row of the pillar line", {}},
      {"step", "step", "time step at which the centre is on the line", {}},
      {"y_um", "um", "centre on the line, not wrapped", {}},
      {"gap_position_um", "um", "centre above the surface of the pillar below", {}},
      {"lane", "none", "lane of the pillar below", {}},
      {"bump", "none", "1: kept its lane since the line before, 0: fell back by one (zig)", {}},
      {"d_perp_um", "um", "largest lateral extent on the line during the passage", {}},
      {"d_perp_at_centre_um", "um", "lateral extent on the line with the centre on it", {}},
      {"film_um", "um", "smallest distance to a pillar while the line cuts the cell", {}},
      {"min_face_ratio", "none", "smallest area of a face relative to its reference", {}},
      {"height_um", "um", "extent along z of the section of largest lateral extent", {}},
      {"speed_um_per_step", "um/step", "mean speed along x since the line before, per time step", {}},
  });
}

}  // namespace

void Extremes::update(const CellView& cell, double node_wall_gap) {
  const MembraneState& state = cell.state;
  area_change = std::max(area_change, std::abs(state.area / cell.membrane.reference_area() - 1.0));
  volume_change = std::max(volume_change, std::abs(state.volume / cell.membrane.reference_volume() - 1.0));
  local_area_strain = std::max(local_area_strain, state.max_local_area_strain);
  min_face_ratio = std::min(min_face_ratio, state.min_face_ratio);
  speed = std::max(speed, cell.speed);
  film = std::min(film, cell.film);
  wall_gap = std::min(wall_gap, node_wall_gap);
}

PassageRecord::PassageRecord() : trajectory(trajectory_table()), crossings(crossings_table()) {}

void PassageRecord::keep_snapshot(const std::string& kind, int row, long step,
                                  const Eigen::MatrixX3d& vertices) {
  const auto count = std::count_if(snapshots_.begin(), snapshots_.end(),
                                   [&](const MembraneSnapshot& s) { return s.name.starts_with(kind); });
  char number[16];
  std::snprintf(number, sizeof number, "_%03d", static_cast<int>(count));
  snapshots_.push_back({kind + number, row, step, vertices});
}

std::vector<XdmfShape> PassageRecord::write(Hdf5File& out, const Membrane& membrane,
                                            const PillarArray& pillars, const PhysicalScales& scales) const {
  if (trajectory.size() > 0) trajectory.write(out, "/trajectory", scales);
  if (crossings.size() > 0) crossings.write(out, "/crossings", scales);
  MembraneOutput shapes(out, membrane, scales, &pillars);
  const double seconds = scales.time_step_s > 0 ? scales.time_step_s : 1;  // steps where there is no scale
  for (const MembraneSnapshot& s : snapshots_) {
    const double time = static_cast<double>(s.step) * seconds;
    const std::string group = shapes.write(s.name, s.vertices, time, "membrane nodes, not wrapped");
    out.attribute(group, "row", s.row);
    out.attribute(group, "step", static_cast<std::int64_t>(s.step));
    out.attribute(group, "time_s", static_cast<double>(s.step) * scales.time_step_s);
  }
  return shapes.series();
}

void PassageRecord::save(Checkpoint& checkpoint) const {
  trajectory.save(checkpoint, "trajectory_");
  crossings.save(checkpoint, "crossings_");
  checkpoint.set("extremes",
                 std::vector<double>{extremes.area_change, extremes.volume_change, extremes.local_area_strain,
                                     extremes.min_face_ratio, extremes.film, extremes.speed,
                                     extremes.density_variation, extremes.wall_gap});
  checkpoint.set("snapshots", static_cast<std::int64_t>(snapshots_.size()));
  for (std::size_t k = 0; k < snapshots_.size(); ++k) {
    const MembraneSnapshot& s = snapshots_[k];
    const std::string name = "snapshot_" + std::to_string(k);
    checkpoint.set(name + "_name", s.name);
    checkpoint.set(name + "_place", std::vector<std::int64_t>{s.row, s.step});
    checkpoint.set(name + "_vertices", to_values(s.vertices));
  }
}

void PassageRecord::load(const Checkpoint& checkpoint) {
  trajectory.load(checkpoint, "trajectory_");
  crossings.load(checkpoint, "crossings_");
  const auto& e = checkpoint.get<std::vector<double>>("extremes");
  extremes = {e[0], e[1], e[2], e[3], e[4], e[5], e[6], e[7]};
  snapshots_.clear();
  for (std::int64_t k = 0; k < checkpoint.integer("snapshots"); ++k) {
    const std::string name = "snapshot_" + std::to_string(k);
    const auto& place = checkpoint.get<std::vector<std::int64_t>>(name + "_place");
    snapshots_.push_back({checkpoint.get<std::string>(name + "_name"), static_cast<int>(place[0]), place[1],
                          to_matrix(checkpoint.get<std::vector<double>>(name + "_vertices"))});
  }
}

}  // namespace dld
