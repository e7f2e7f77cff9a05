#include "scene/passage_state.hpp"

#include <cstdint>

#include "parameters/units.hpp"
#include "scene/coupled_state.hpp"

namespace dld {
namespace {

ReturnMapOptions map_options(const Case& c) {
  ReturnMapOptions options;
  options.epsilon = c.geometry.epsilon();
  options.tolerance = c.stop.map_tolerance_um / c.fluid.lattice_spacing_um;
  options.max_rows = c.stop.max_rows;
  return options;
}

}  // namespace

PassageState::PassageState(const Case& c, const Device& device)
    : extent(device.gap_line().x),
      gap_(device.gap_line()),
      has_separations_(!device.empty() && c.geometry.row_shift_um != 0),
      map_(map_options(c)) {
  const LatticeParameters l = to_lattice(c);
  pitch_x_ = l.nx;
  pitch_y_ = l.ny;
  row_shift_ = l.row_shift;
}

TrajectoryClass PassageState::add_crossing(double y) {
  const int crossed = static_cast<int>(heights_.size());
  heights_.push_back(y);
  return map_.add(crossing_at(y, crossed, pitch_y_, row_shift_, gap_));
}

double PassageState::line_of_row() const {
  return gap_.x + static_cast<double>(row) * pitch_x_;
}

void PassageState::save(Checkpoint& checkpoint) const {
  const auto whole = [&](const char* name, long value) {
    checkpoint.set(name, static_cast<std::int64_t>(value));
  };
  whole("flow_steps", flow.steps);
  checkpoint.set("mean_velocity", flow.along);
  checkpoint.set("mean_across", flow.across);
  if (flow.separations) save_separations(checkpoint, *flow.separations);
  whole("row", row);
  checkpoint.set("extent", extent.numbers());
  checkpoint.set("extent_vertices", to_values(extent.vertices_at_max()));
  whole("crossing_added", crossing_added ? 1 : 0);
  whole("decided", decided ? 1 : 0);
  checkpoint.set("heights", heights_);
  record.save(checkpoint);
  checkpoint.set("last_recorded", std::vector<double>(last_recorded.data(), last_recorded.data() + 3));
  whole("last_snapshot", last_snapshot);
  whole("last_good_row", last_good.row);
  whole("last_good_step", last_good.step);
  checkpoint.set("last_good_vertices", to_values(last_good.vertices));
}

void PassageState::load(const Checkpoint& checkpoint) {
  const auto values = [&](const char* name) -> const auto& {
    return checkpoint.get<std::vector<double>>(name);
  };
  flow.steps = checkpoint.integer("flow_steps");
  flow.along = values("mean_velocity").at(0);
  flow.across = values("mean_across").at(0);
  if (has_separations()) flow.separations = load_separations(checkpoint);
  row = static_cast<int>(checkpoint.integer("row"));
  extent = PassageExtent::from(values("extent"), to_matrix(values("extent_vertices")));
  crossing_added = checkpoint.integer("crossing_added") != 0;
  decided = checkpoint.integer("decided") != 0;
  for (const double y : values("heights")) add_crossing(y);
  record.load(checkpoint);
  last_recorded = to_matrix(values("last_recorded")).row(0).transpose();
  last_snapshot = checkpoint.integer("last_snapshot");
  last_good = {"last_good", static_cast<int>(checkpoint.integer("last_good_row")),
               checkpoint.integer("last_good_step"), to_matrix(values("last_good_vertices"))};
}

}  // namespace dld
