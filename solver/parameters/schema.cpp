/// What follows from the parameter table besides reading: the resolved echo and the JSON Schema.
#include <algorithm>
#include <cmath>

#include "parameters/declaration.hpp"
#include "parameters/operating.hpp"
#include "parameters/pillar_json.hpp"
#include "parameters/presets.hpp"
#include "parameters/reader.hpp"
#include "parameters/scene_rules.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

/// Part of every run's identity in a study. Raise it with any change of the solver that changes results: all
/// runs are then made again.
constexpr int solver_model = 4;

using Json = nlohmann::ordered_json;

Json type_of(const Field& field) {
  static const Json types = {"number", "integer", "integer", "boolean", "string",
                             "array",  "number",  "object",  "string"};
  return types.at(field.index());
}

// A limit as the schema should show it: whole numbers without a fraction.
Json limit(double value) {
  if (std::trunc(value) == value && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

void add_limits(Json& schema, const Allowed& allowed) {
  if (!allowed.names.empty()) schema["enum"] = allowed.names;
  if (std::isfinite(allowed.minimum)) {
    schema[allowed.open_minimum ? "exclusiveMinimum" : "minimum"] = limit(allowed.minimum);
  }
  if (std::isfinite(allowed.maximum)) schema["maximum"] = limit(allowed.maximum);
}

Json value_of(const Field& field) {
  return std::visit(
      []<class T>(T* value) -> Json {
        if constexpr (std::is_same_v<T, std::optional<PillarValues>>) {
          return value->has_value() ? pillar_json(**value) : Json();
        } else if constexpr (requires { value->has_value(); }) {
          return value->has_value() ? Json(**value) : Json();
        } else {
          return *value;
        }
      },
      field);
}

// What a case does not give: nothing, an empty text or an empty list.
bool is_absent(const Json& value) {
  return value.is_null() || (value.is_string() && value.get<std::string>().empty()) ||
         (value.is_array() && value.empty());
}

Json property(const Declaration& declaration, Case& defaults) {
  Json schema = {{"description", with_unit(declaration.doc, declaration.unit)}};
  if (!declaration.field) {
    schema["type"] = "number";
    add_limits(schema, declaration.allowed);
    return schema;
  }
  const Field field = declaration.field(defaults);
  if (std::holds_alternative<std::optional<PillarValues>*>(field)) {
    schema.update(pillar_schema());
    return schema;
  }
  schema["type"] = type_of(field);
  if (schema["type"] == "array") {
    schema["items"] = {{"type", "number"}};
    add_limits(schema["items"], declaration.allowed);
    schema["minItems"] = std::max<std::size_t>(1, declaration.allowed.items);
    if (declaration.allowed.items > 0) schema["maxItems"] = declaration.allowed.items;
  } else {
    add_limits(schema, declaration.allowed);
  }
  const Json value = value_of(field);
  if (declaration.name != "scene" && !is_absent(value)) schema["default"] = value;
  return schema;
}

// The object schema of a section within the schema of the whole, made on first use.
Json& section_schema(Json& root, std::string_view section) {
  Json* schema = &root;
  while (!section.empty()) {
    const auto slash = section.find('/');
    Json& child = (*schema)["properties"][std::string(section.substr(0, slash))];
    if (child.is_null())
      child = {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
    schema = &child;
    section = slash == std::string_view::npos ? std::string_view{} : section.substr(slash + 1);
  }
  return *schema;
}

}  // namespace

Json echo(const Case& c) {
  Case copy = c;  // the fields of the table are not const
  Json tree;
  for (const auto& declaration : declarations()) {
    const Json value = value_of(declaration.field(copy));
    if (!is_absent(value)) tree[Json::json_pointer(declaration.pointer())] = value;
  }
  if (c.geometry.pillar) {
    for (const char* short_form : {"pillar_shape", "pillar_radius_um"}) tree["geometry"].erase(short_form);
  }
  return tree;
}

Json case_schema() {
  Case defaults;
  Json root = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
               {"$id", "urn:dld:schema:case"},
               {"title", "One run of the solver dld"},
               {"x-solver-model", solver_model},
               {"type", "object"},
               {"required", {"scene"}},
               {"additionalProperties", false},
               {"properties", Json::object()}};
  for (const auto& declaration : declarations()) {
    section_schema(root, declaration.section)["properties"][std::string(declaration.name)] =
        property(declaration, defaults);
  }
  for (const auto& name : annotations) {
    const char* meaning = "about the case; changes nothing and is no part of a run's identity";
    root["properties"][name] = {{"description", meaning}, {"type", "string"}};
  }
  // Optional, without defaults: a case that does not have it stays what it was.
  Json& operating = section_schema(root, "operating");
  operating["description"] =
      "operating conditions in SI units: one drive, from which the capillary number is computed; the case "
      "then gives none itself";
  for (const auto& [declaration, member] : operating_declarations()) {
    operating["properties"][std::string(declaration.name)] = property(declaration, defaults);
  }
  operating["dependentRequired"] = {{"pressure_drop_mbar", {"length_mm"}},
                                    {"length_mm", {"pressure_drop_mbar"}},
                                    {"flow_rate_uL_per_min", {"channel_width_um"}},
                                    {"channel_width_um", {"flow_rate_uL_per_min"}}};
  // An annotation: the defaults that each preset puts in place of those stated below.
  Json& annotation = root["properties"]["accuracy"]["x-presets"];
  for (const auto& p : presets()) annotation[p.name] = p.settings;
  // And the sections that each scene reads: the others are without effect on a run.
  Json& reads = root["properties"]["scene"]["x-sections"];
  for (const auto& rules : scene_rules()) reads[rules.name] = rules.sections;
  Json& geometry = section_schema(root, "geometry");
  geometry["properties"]["epsilon"] = property(epsilon_declaration(), defaults);
  const auto both = [](const char* a, const char* b) { return Json{{"required", {a, b}}}; };
  geometry["not"] = {{"anyOf",
                      {both("epsilon", "row_shift_um"), both("pillar", "pillar_shape"),
                       both("pillar", "pillar_radius_um")}}};
  return root;
}

}  // namespace dld
