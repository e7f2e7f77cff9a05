#include "scene/passage_record.hpp"

#include <stdexcept>

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

void ColumnTable::write(Hdf5File& out, const std::string& group) const {
  for (const Column& column : columns_) out.write(group + "/" + column.name, column.values, column.unit, column.description);
}

void ColumnTable::save(Checkpoint& checkpoint, const std::string& prefix) const {
  for (const Column& column : columns_) checkpoint.set(prefix + column.name, column.values);
}

void ColumnTable::load(const Checkpoint& checkpoint, const std::string& prefix) {
  for (Column& column : columns_) column.values = checkpoint.get<std::vector<double>>(prefix + column.name);
}

ColumnTable trajectory_table() {
  return ColumnTable({
      {"step", "1", "time step", {}},
      {"x_um", "um", "centre, relative to the pillar of row 0, not wrapped", {}},
      {"y_um", "um", "centre, relative to the pillar of row 0, lane 0, not wrapped", {}},
      {"z_um", "um", "centre above the mid plane", {}},
      {"extent_x_um", "um", "extent of the cell along x", {}},
      {"extent_y_um", "um", "extent of the cell along y", {}},
      {"extent_z_um", "um", "extent of the cell along z", {}},
      {"area_change", "1", "(A - A0) / A0", {}},
      {"volume_change", "1", "(V - V0) / V0", {}},
      {"min_face_ratio", "1", "smallest area of a face relative to its reference", {}},
      {"film_um", "um", "smallest distance between the membrane and a pillar", {}},
  });
}

ColumnTable crossings_table() {
  return ColumnTable({
      {"row", "1", "row of the pillar line", {}},
      {"step", "1", "time step at which the centre is on the line", {}},
      {"y_um", "um", "centre on the line, not wrapped", {}},
      {"gap_position_um", "um", "centre above the surface of the pillar below", {}},
      {"lane", "1", "lane of the pillar below", {}},
      {"bump", "1", "1: kept its lane since the line before, 0: fell back by one (zig)", {}},
      {"d_perp_um", "um", "largest lateral extent on the line during the passage", {}},
      {"d_perp_at_centre_um", "um", "lateral extent on the line with the centre on it", {}},
      {"film_um", "um", "smallest distance to a pillar while the line cuts the cell", {}},
      {"min_face_ratio", "1", "smallest area of a face relative to its reference", {}},
      {"height_um", "um", "extent along z of the section of largest lateral extent", {}},
      {"speed_um_per_step", "um", "mean speed along x since the line before, per time step", {}},
  });
}

}  // namespace dld
