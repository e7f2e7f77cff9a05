#include "scene/passage_summary.hpp"

#include <cmath>

#include "parameters/physical.hpp"
#include "parameters/units.hpp"
#include "scene/device_output.hpp"
#include "scene/flow_output.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;

void summarise_case(const Case& c, const Device& device, RunContext& context) {
  Json& s = context.summary;
  s["row_shift_um"] = c.geometry.row_shift_um;
  s["epsilon"] = c.geometry.epsilon();
  s["dx_um"] = c.fluid.lattice_spacing_um;
  write_device(context, device, c.fluid.lattice_spacing_um);
  s["capillary_number"] = c.cell.capillary_number;
  s["skalak_denominator"] = c.cell.skalak_denominator;
  s["bending_law"] = c.cell.bending_law;
  s["fold_modulus_N_m"] = fold_modulus_N_m(c);
  s["lateral_flow"] = c.fluid.lateral_flow;
}

/// D_perp and what else was measured on the pillar line that defines it; null without one.
void summarise_defining_crossing(const ReturnMap& map, const ColumnTable& crossings, Json& s) {
  const int defining = map.defining_crossing();
  const bool known = defining >= 0 && static_cast<std::size_t>(defining) < crossings.size();
  const auto value = [&](const char* column) -> Json {
    if (!known) return nullptr;
    return crossings.column(column)[static_cast<std::size_t>(defining)];
  };
  s["defining_crossing"] = defining;
  s["d_perp_um"] = value("d_perp_um");
  s["d_perp_at_centre_um"] = value("d_perp_at_centre_um");
  s["centre_um"] = value("gap_position_um");
  s["film_um"] = value("film_um");
  s["height_um"] = value("height_um");
  s["speed_um_per_step"] = value("speed_um_per_step");
}

void summarise_map(const MapBracket& bracket, double um, Json& s) {
  const auto length = [um](double x) { return std::isnan(x) ? Json() : Json(x * um); };
  s["map_limit_um"] = bracket.limit * um;
  s["map_ratio"] = bracket.ratio;
  s["map_step_um"] = bracket.step * um;
  s["map_lowest_bump_um"] = length(bracket.lowest_bump);
  s["map_highest_zig_um"] = length(bracket.highest_zig);
}

void summarise_extremes(const Extremes& extremes, double um, Json& s) {
  const auto distance = [um](double d) { return d < no_distance ? Json(d * um) : nullptr; };
  s["area_change"] = extremes.area_change;
  s["volume_change"] = extremes.volume_change;
  s["max_local_area_strain"] = extremes.local_area_strain;
  s["min_face_ratio"] = extremes.min_face_ratio;
  s["smallest_film_um"] = distance(extremes.film);
  s["smallest_wall_gap_um"] = distance(extremes.wall_gap);
  s["max_speed"] = extremes.speed;
  s["density_variation"] = extremes.density_variation;
}

/// Effort in units that no machine changes.
void summarise_work(const PassageState& state, const SimulatedSize& size, Json& s) {
  s["regularisation_mobility"] = size.mobility;
  s["odd_columns"] = size.odd_columns;
  s["steps"] = state.steps + state.flow.steps;
  s["node_updates"] = (state.steps + state.flow.steps) * size.fluid_nodes;
  s["membrane_updates"] = state.steps * size.vertices;
  s["memory_bytes"] = size.memory_bytes;
}

void summarise_flow(const Case& c, const CellFreeFlow& flow, Json& s) {
  const SiScales si = to_si(c);
  s["si"] = {{"pressure_gradient_bar_per_m", si.pressure_gradient_Pa_per_m * 1e-5},
             {"mean_velocity_mm_per_s", flow.along * si.velocity_m_per_s_per_lu * 1e3}};
  summarise_mean_flow(c, flow.along, flow.across, s);
}

}  // namespace

void summarise_passage(const Case& c, const Device& device, const PassageState& state, const PassageEnd& end,
                       const SimulatedSize& size, RunContext& context) {
  Json& s = context.summary;
  const double um = c.fluid.lattice_spacing_um;
  summarise_case(c, device, context);
  s["class"] = to_string(end.status);
  if (!end.reason.empty()) s["reason"] = end.reason;
  summarise_defining_crossing(state.map(), state.record.crossings, s);
  summarise_map(state.map().bracket(), um, s);
  s["crossings"] = state.record.crossings.size();
  s["zigs"] = state.map().zigs();
  summarise_extremes(state.record.extremes, um, s);
  summarise_work(state, size, s);
  summarise_flow(c, state.flow, s);
  if (!end.failure) return;
  report_failure(*end.failure, size.with_cell ? state.steps : state.flow.steps, s);
  if (state.last_good.vertices.size() > 0) s["last_good_step"] = state.last_good.step;
}

}  // namespace dld
