#include "parameters/reader.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "parameters/advice.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/consistency.hpp"
#include "parameters/declaration.hpp"
#include "parameters/declared_value.hpp"
#include "parameters/effect.hpp"
#include "parameters/operating.hpp"
#include "parameters/presets.hpp"
#include "parameters/syntax.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;

// Enough of a text from outside to find it.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 200;
  if (text.size() <= most) return text;
  std::size_t end = most;
  while ((static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // no half of a letter
  return text.substr(0, end) + "...";
}

// One line: no text of the file begins another.
std::string problem_text(const std::string& file, const Problem& problem) {
  std::string text = file + ": " + (problem.pointer.empty() ? "/" : shortened(problem.pointer));
  if (!problem.value.empty()) text += " = " + shortened(problem.value);
  if (!problem.allowed.empty()) text += ": allowed is " + problem.allowed;
  if (!problem.advice.empty()) text += "; " + problem.advice;
  return printable(text);
}

std::string list_text(const std::string& file, const std::vector<Problem>& problems) {
  std::string text;
  for (const auto& problem : problems) text += (text.empty() ? "" : "\n") + problem_text(file, problem);
  return text;
}

// Names that may stand in a section: parameters and sub-sections.
std::vector<std::string> known_names(const std::string& section) {
  std::vector<std::string> names;
  for (const auto& declaration : declarations()) {
    if (declaration.section == section) names.emplace_back(declaration.name);
  }
  if (section == "geometry") names.emplace_back(epsilon_declaration().name);
  if (section.empty()) names.insert(names.end(), annotations.begin(), annotations.end());
  if (section.empty()) names.emplace_back("operating");
  if (section == "operating") {
    for (const auto& key : operating_declarations()) names.emplace_back(key.declaration.name);
  }
  for (const auto& other : sections()) {
    const auto slash = other.rfind('/');
    const std::string parent = slash == std::string::npos ? "" : other.substr(0, slash);
    if (parent == section) names.push_back(slash == std::string::npos ? other : other.substr(slash + 1));
  }
  return names;
}

// The object of a section; nullptr if it is absent.
const Json* section_object(const Json& root, const std::string& section, std::vector<Problem>& problems) {
  const nlohmann::json::json_pointer pointer(section.empty() ? "" : "/" + section);
  if (!root.contains(pointer)) return nullptr;
  const Json& object = root.at(pointer);
  if (!object.is_object()) {
    problems.push_back({pointer.to_string(), object.dump(), "an object", "write { ... }"});
    return nullptr;
  }
  return &object;
}

// Names in a section that it does not have; the case serves the advice.
void check_names(const Json& object, const std::string& section, const Case& c,
                 std::vector<Problem>& problems) {
  const auto known = known_names(section);
  constexpr int most = 50;  // advice on each of many is no help, and takes long
  int unknown = 0;
  const nlohmann::json::json_pointer pointer((section.empty() ? "" : "/" + section));
  for (const auto& [name, value] : object.items()) {
    if (std::ranges::find(known, name) != known.end()) continue;
    if (++unknown > most) {
      problems.push_back({pointer.to_string(), "", "one of the names " + joined(known),
                          "there are more unknown names than these " + std::to_string(most)});
      return;
    }
    problems.push_back({(pointer / name).to_string(), value.dump(), "one of the names " + joined(known),
                        unknown_name_advice(name, value, known, c)});
  }
}

// Words about the case itself, which change nothing.
void check_annotations(const Json& root, std::vector<Problem>& problems) {
  for (const auto& name : annotations) {
    if (root.is_object() && root.contains(name) && !root[name].is_string())
      problems.push_back({"/" + name, root[name].dump(), "a text", "write it in quotes, or remove the key"});
  }
}

// epsilon is the other way of giving the row shift.
std::optional<double> read_epsilon(const Json& geometry, std::vector<Problem>& problems) {
  if (!geometry.contains("epsilon")) return std::nullopt;
  if (geometry.contains("row_shift_um")) {
    problems.push_back({"/geometry/epsilon", geometry["epsilon"].dump(), "either epsilon or row_shift_um",
                        "remove one of the two"});
  }
  return declared_number(epsilon_declaration(), geometry["epsilon"], problems);
}

// The pillar has two forms.
void refuse_both_pillars(const Json& geometry, std::vector<Problem>& problems) {
  for (const char* name : {"pillar_shape", "pillar_radius_um"}) {
    if (!geometry.contains("pillar") || !geometry.contains(name)) continue;
    problems.push_back({std::string("/geometry/") + name, geometry[name].dump(),
                        "either pillar, or pillar_shape and pillar_radius_um", "remove one of the two"});
  }
}

// The section whose keys have no defaults.
void read_operating(const Json& root, Case& c, std::vector<Problem>& problems) {
  const Json* object = section_object(root, "operating", problems);
  if (!object) return;
  for (const auto& [declaration, member] : operating_declarations()) {
    if (!object->contains(declaration.name)) continue;
    const Json& value = object->at(std::string(declaration.name));
    c.operating.*member = declared_number(declaration, value, problems);
  }
}

// Puts the settings of the case's preset in place of the defaults; a wrong name is reported with the others.
void apply_preset(const Json& root, Case& c) {
  std::string name = c.accuracy;
  if (root.is_object() && root.contains("accuracy") && root["accuracy"].is_string()) {
    const auto given = root["accuracy"].get<std::string>();
    const auto names = preset_names();
    if (names.end() != std::ranges::find(names, given)) name = given;
  }
  const Json& settings = preset(name).settings;
  std::vector<Problem> none;
  for (const auto& declaration : declarations()) {
    const Json::json_pointer pointer(declaration.pointer());
    if (settings.contains(pointer))
      store_value(declaration, settings.at(pointer), declaration.field(c), none);
  }
}

}  // namespace

CaseError::CaseError(const std::string& file, std::vector<Problem> list)
    : std::runtime_error(list_text(file, list)), problems(std::move(list)) {}

Reading read_tree(const Json& root, const std::string& folder) {
  Reading reading;
  auto& [c, problems] = reading;
  apply_preset(root, c);
  std::optional<double> epsilon;
  if (root.is_object() && !root.contains("scene")) {
    problems.push_back({"/scene", "", "one of the scenes; it is required", "add \"scene\": \"passage\""});
  }
  std::vector<std::string> all_sections = sections();
  all_sections.insert(all_sections.begin(), "");
  for (const auto& section : all_sections) {
    const Json* object = section_object(root, section, problems);
    if (!object) continue;
    for (const auto& declaration : declarations()) {
      if (declaration.section != section || !object->contains(declaration.name)) continue;
      store_value(declaration, object->at(std::string(declaration.name)), declaration.field(c), problems);
    }
    if (section == "geometry") {
      epsilon = read_epsilon(*object, problems);
      refuse_both_pillars(*object, problems);
    }
  }
  read_operating(root, c, problems);
  all_sections.emplace_back("operating");
  for (const auto& section : all_sections) {
    const nlohmann::json::json_pointer pointer(section.empty() ? "" : "/" + section);
    if (root.contains(pointer) && root.at(pointer).is_object())
      check_names(root.at(pointer), section, c, problems);
  }
  check_annotations(root, problems);
  if (!without_effect("/cell/shape", c)) complete_cell(root, folder, c.cell, problems);
  if (!problems.empty()) return reading;
  if (epsilon) {
    c.geometry.row_shift_um = *epsilon * c.geometry.pitch_across_um();
    c.geometry.by_epsilon = true;
  }
  // The default of the schema is that of the default pitch.
  if (!root.contains("/cell/start/x_um"_json_pointer)) c.cell.start.x_um = -0.5 * c.geometry.pitch_um;
  problems = inconsistencies(c);
  if (problems.empty()) resolve_operating(c, root.contains("/cell/capillary_number"_json_pointer), problems);
  if (problems.empty()) c.warnings = effect_warnings(root, c);
  return reading;
}

Case parse_case(const std::string& text, const std::string& name) {
  std::vector<Problem> problems;
  const Json root = parse_json(text, problems);
  if (!problems.empty()) throw CaseError(name, problems);
  Reading reading = read_tree(root, std::filesystem::path(name).parent_path().string());
  if (!reading.problems.empty()) throw CaseError(name, reading.problems);
  return reading.c;
}

std::string read_text(const std::filesystem::path& path) {
  constexpr std::size_t most = std::size_t{256} << 20, piece = std::size_t{1} << 20;
  std::ifstream in(path, std::ios::binary);
  std::string text;
  while (in && text.size() <= most) {
    const std::size_t before = text.size();
    text.resize(before + piece);
    in.read(text.data() + before, static_cast<std::streamsize>(piece));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  if (text.size() > most)
    throw CaseError(path.string(), {{"", "", "a file of at most 256 MiB", "check the path"}});
  if (!in.eof() || in.bad()) throw CaseError(path.string(), {{"", "", "a readable file", "check the path"}});
  return text;
}

Case read_case(const std::filesystem::path& path) {
  return parse_case(read_text(path), path.string());
}

}  // namespace dld
