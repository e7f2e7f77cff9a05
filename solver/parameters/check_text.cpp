#include "parameters/check_text.hpp"

#include <algorithm>

#include "parameters/cell_surface.hpp"
#include "parameters/limits.hpp"
#include "parameters/memory.hpp"
#include "parameters/operating.hpp"
#include "parameters/physical.hpp"
#include "parameters/pillar_json.hpp"
#include "parameters/presets.hpp"
#include "parameters/reader.hpp"
#include "parameters/report.hpp"
#include "parameters/text.hpp"
#include "parameters/units.hpp"

namespace dld {

using Json = nlohmann::ordered_json;

namespace {

std::string n(double value) {
  return short_number(value);
}

std::string scene_words(const Case& c) {
  if (c.scene == "passage") return "passage: one cell through the array until its class is known";
  if (c.scene == "streamlines") return "streamlines: flow through the array without a cell";
  if (c.scene == "stretching") return "stretching: a cell pulled at both ends, " + c.stretching.method;
  if (c.scene == "shear") return "shear: a capsule between moving walls";
  return "channel: flow through a channel without pillars or cell";
}

std::string device_words(const Case& c) {
  const GeometryParameters& g = c.geometry;
  if (c.scene == "shear") return "cubic box of " + n(c.shear.box_um) + " um";
  if (c.scene == "stretching") return c.stretching.method == "static" ? "none" : "box of quiescent fluid";
  if (c.scene == "channel") {
    const bool duct = c.channel.width_um > 0;
    return (duct ? "duct, width " + n(c.channel.width_um) + " um" : "plane channel") + ", depth " +
           n(g.depth_um) + " um";
  }
  const std::string across = g.pitch_y_um ? " (across the flow " + n(*g.pitch_y_um) + " um)" : "";
  const std::string array = "pitch " + n(g.pitch_um) + " um" + across + ", depth " + n(g.depth_um) +
                            " um, row shift d = " + n(g.row_shift_um) +
                            " um (epsilon = d / pitch across the flow = " + n(g.epsilon()) + ")";
  const Device device = device_um(c);
  if (device.empty()) return "empty slit, " + array;
  return "pillars: " + pillar_words(g.pillar_values(), short_number) + "; gap " + n(device.gap()) + " um, " +
         array;
}

std::string cell_words(const Case& c) {
  if (c.scene == "streamlines" || c.scene == "channel") return "none";
  std::string shape = c.cell.shape;
  std::ranges::replace(shape, '_', ' ');
  const Json numbers = dimensionless_numbers(c);
  std::string words = shape + ", radius " + n(c.cell.radius_um) + " um";
  if (!sized_by_radius(c.cell)) words += " (from " + size_pointer(c.cell) + ")";
  if (numbers.contains("capillary_number")) words += ", Ca " + n(numbers["capillary_number"]);
  if (c.scene == "stretching") {
    words += ", shear modulus kS " + n(c.stretching.shear_modulus_uN_per_m) + " uN/m, forces " +
             n(std::ranges::min(c.stretching.forces_pN)) + " to " +
             n(std::ranges::max(c.stretching.forces_pN)) + " pN";
  }
  return words + ", viscosity ratio " + n(c.cell.viscosity_ratio) + ", area modulus " +
         n(numbers["local_area_per_shear_modulus"]) + " kS, bending law " + c.cell.bending_law + ", " +
         std::to_string(face_count(c.cell)) + " faces";
}

std::string physical_words(const Case& c) {
  const Json si = si_numbers(c);
  const PhysicalScales scales = physical_scales(c);
  std::string words;
  if (si.contains("pressure_gradient_bar_per_m"))
    words += "pressure gradient " + n(si["pressure_gradient_bar_per_m"]) + " bar/m, ";
  if (const Json operating = operating_json(c); operating.is_object()) {
    words += "expected mean speed " + n(operating["mean_speed_um_per_s"]) + " um/s and flow rate " +
             n(operating["flow_rate_uL_per_min_per_um_of_width"]) + " uL/min per um of width (to " +
             n(operating["uncertainty_of_speeds_percent"]) + " %), ";
  }
  if (si.contains("shear_rate_per_s")) words += "shear rate " + n(si["shear_rate_per_s"]) + " per s, ";
  if (scales.time_step_s > 0) words += "time step " + n(1e6 * scales.time_step_s) + " us; from the ";
  return words + scales.basis;
}

std::string lattice_words(const Case& c) {
  const LatticeParameters l = scene_lattice(c);
  if (l.um_per_lu == 0) return "none";
  const std::string height = l.half_height ? ", half the height" : "";
  if (c.scene == "channel")
    return "spacing " + n(l.um_per_lu) + " um" + height + ", " + c.fluid.precision + " precision";
  return std::to_string(l.nx) + " x " + std::to_string(l.ny) + " x " + std::to_string(l.nz) +
         " nodes, spacing " + n(l.um_per_lu) + " um" + height + ", relaxation time " + n(l.tau_outside) +
         (l.force_density > 0 ? ", force density " + n(l.force_density) + " lu" : "") + ", " +
         c.fluid.precision + " precision";
}

std::string accuracy_words(const Case& c) {
  const Json accuracy = accuracy_json(c);
  std::string words = "preset " + c.accuracy;
  if (c.scene != "passage") return words;
  const Json& error = accuracy["expected_error"];
  const auto percent = [&](const char* key) {
    return error[key].is_number() ? n(error[key]) + " %" : std::string("not measured");
  };
  words += ", expected errors: D_perp " + percent("d_perp_percent") + ", centre " +
           percent("centre_percent") + ", critical Ca " + percent("critical_capillary_percent");
  std::vector<std::string> departs = accuracy["departs_in"];
  if (!departs.empty()) words += "; not for this case, which sets " + joined(departs);
  return words;
}

std::string cost_words(const Case& c) {
  const Json cost = expected_cost(c);
  const std::string memory = n(memory_MiB(c)) + " MiB";
  return "about " + n(cost["steps"]) + " steps, " + n(cost["seconds_on_one_core"]) +
         " s on one core with AVX-512, " + memory;
}

std::string margin_words(const std::vector<Margin>& margins) {
  const auto hold = std::ranges::count_if(margins, &Margin::ok);
  if (margins.empty()) return "none to check for this scene";
  std::string words = std::to_string(hold) + " of " + std::to_string(margins.size()) + " hold";
  if (const Margin* worst = tightest(margins)) {
    words += "; tightest: " + worst->name + " = " + quantity_text(worst->value, worst->unit) + ", " +
             n(100 * worst->share) + " % of what is allowed";
  }
  return words;
}

}  // namespace

std::string quantity_text(double value, const std::string& unit) {
  return short_number(value) + (unit.empty() ? "" : " " + unit);
}

std::string check_text(const Case& c) {
  const std::vector<Margin> margins = stability_margins(c);
  const auto violated = std::ranges::count_if(margins, [](const Margin& m) { return !m.ok; });
  const auto warnings = violated + std::ssize(c.warnings);
  const std::pair<const char*, std::string> lines[] = {
      {"scene", scene_words(c)},
      {"device", device_words(c)},
      {"cell", cell_words(c)},
      {"physical", physical_words(c)},
      {"lattice", lattice_words(c)},
      {"accuracy", accuracy_words(c)},
      {"cost", cost_words(c)},
      {"margins", margin_words(margins)},
      {"warnings", warnings == 0 ? "none" : std::to_string(warnings) + ", see below"},
      {"more", "dld check --json prints every number"}};
  std::string text;
  for (const auto& [name, words] : lines) {
    text += name + std::string(10 - std::string_view(name).size(), ' ') + words + "\n";
  }
  return text;
}

Json check_json(const Case& c) {
  return {{"case", echo(c)},
          {"accuracy", accuracy_json(c)},
          {"lattice", lattice_numbers(c)},
          {"dimensionless", dimensionless_numbers(c)},
          {"si", si_numbers(c)},
          {"operating", operating_json(c)},
          {"memory_MiB", memory_MiB(c)},
          {"expected_cost", expected_cost(c)},
          {"margins", margins_json(stability_margins(c))},
          {"warnings", c.warnings}};
}

}  // namespace dld
