#include "parameters/advice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parameters/effect.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

/// The symbol with which the description of a parameter begins: "Ca" of "Ca = p' l r / kS", "H" of "H,
/// between"; empty if it begins with words.
std::string symbol_of(const Declaration& declaration) {
  constexpr std::size_t longest = 6;
  const std::string_view doc = declaration.doc;
  const auto end = std::min(doc.find_first_of(" ,"), doc.size());
  const std::string_view rest = doc.substr(end);
  const bool symbol = end <= longest && (rest.empty() || rest.starts_with(",") || rest.starts_with(" = ") ||
                                         rest.starts_with(" of ") || rest.starts_with(" in "));
  return symbol ? std::string(doc.substr(0, end)) : "";
}

/// The first of the declarations that `match`, of those that have an effect if any does; nullptr if none
/// matches.
template <class Match>
const Declaration* best_match(const Case& c, Match&& match) {
  const Declaration* best = nullptr;
  for (const Declaration& d : declarations()) {
    if (!match(d)) continue;
    if (!without_effect(d.pointer(), c)) return &d;
    if (!best) best = &d;
  }
  return best;
}

/// Where a declared name is to be written; what to use instead where it would have no effect.
std::string place_advice(const Declaration& d, const Case& c) {
  const auto none = without_effect(d.pointer(), c);
  if (!none) return "it belongs at " + d.pointer();
  const std::string why = " (of " + d.pointer() + ": " + none->reason + ")";
  return none->instead.empty() ? "remove it" + why : "use " + none->instead + why;
}

std::string gap_advice(const nlohmann::ordered_json& value, const GeometryParameters& g) {
  const std::string rule = "the gap is /geometry/pitch_um less twice /geometry/pillar_radius_um";
  if (!value.is_number() || value.get<double>() <= 0 || value.get<double>() >= g.pitch_um) return rule;
  const double gap_um = value.get<double>();
  return rule + ": for " + number_text(gap_um) + " um set /geometry/pitch_um to " +
         number_text(gap_um + 2 * g.pillar_radius_um) + " or /geometry/pillar_radius_um to " +
         number_text((g.pitch_um - gap_um) / 2);
}

/// The lengths of a scene and how many spacings make the unit of each.
std::vector<std::pair<double, int>> lengths_um(const Case& c) {
  const int per_depth = c.geometry.height == "half" ? 2 : 1;
  if (c.scene == "shear") return {{c.shear.box_um, 1}};
  if (c.scene == "channel") return {{c.geometry.depth_um, per_depth}, {c.channel.width_um, 1}};
  return {{c.geometry.pitch_um, 1}, {c.geometry.row_shift_um, 1}, {c.geometry.depth_um, per_depth}};
}

}  // namespace

std::string unknown_name_advice(const std::string& name, const nlohmann::ordered_json& value,
                                const std::vector<std::string>& known, const Case& c) {
  for (const char* gap : {"G", "gap", "gap_um"}) {
    if (name == gap) return gap_advice(value, c.geometry);
  }
  if (const auto* d = best_match(c, [&](const Declaration& other) { return other.name == name; }))
    return place_advice(*d, c);
  if (const auto* d = best_match(c, [&](const Declaration& other) { return symbol_of(other) == name; }))
    return "did you mean " + d->pointer() + " (" + std::string(d->doc) + ")?";
  if (const auto near = similar_name(name, known)) return "did you mean \"" + *near + "\"?";
  std::vector<std::string> all;
  for (const Declaration& d : declarations()) all.emplace_back(d.name);
  if (const auto near = similar_name(name, all)) {
    const auto* d = best_match(c, [&](const Declaration& other) { return other.name == *near; });
    return "did you mean \"" + *near + "\"? " + place_advice(*d, c);
  }
  return "remove it";
}

std::string unknown_text_advice(const std::string& given, const Allowed& allowed) {
  if (const auto near = similar_name(given, allowed.names)) return "use " + nlohmann::json(*near).dump();
  return allowed.meaning.empty() ? "use one of them" : allowed.meaning;
}

std::string fitting_spacings(const Case& c) {
  constexpr double rounding = 1e-9;
  const auto lengths = lengths_um(c);
  const auto fits = [&](double dx) {
    return std::ranges::all_of(lengths, [&](const auto& length) {
      const double n = length.first / (length.second * dx);
      return std::abs(n - std::round(n)) <= rounding * std::max(1.0, n) && (length.first == 0 || n > 0.5);
    });
  };
  const double dx = c.fluid.lattice_spacing_um, length = lengths.front().first;
  std::vector<std::string> found;
  const auto first_of = [&](double from, double to, double step) {
    for (double n = from; step * (to - n) >= 0; n += step) {
      if (n < 1 || !fits(length / n)) continue;
      found.push_back(number_text(length / n));
      return;
    }
  };
  // A lattice that is finer than a thousandth of the length is no advice, and takes long to look for.
  const double now = std::min(length / dx, 1000.0);
  first_of(std::floor(now), std::ceil(now / 2), -1);
  first_of(std::floor(now) + 1, std::floor(2 * now), 1);
  if (found.empty()) return "another /fluid/lattice_spacing_um";
  return "a /fluid/lattice_spacing_um of " + (found.size() == 2 ? found[0] + " or " + found[1] : found[0]) +
         (found.size() == 2 ? ", which fit all lengths" : ", which fits all lengths");
}

}  // namespace dld
