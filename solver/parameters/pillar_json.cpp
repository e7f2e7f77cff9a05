#include "parameters/pillar_json.hpp"

#include <algorithm>
#include <cmath>

#include "parameters/declaration.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;
using Kind = PillarParameter::Kind;

Allowed allowed_of(const PillarParameter& p) {
  return {p.minimum, p.maximum, p.open_minimum, {}};
}

bool is_number(const Json& value, const PillarParameter& p) {
  return value.is_number() && in_range(value.get<double>(), allowed_of(p)) &&
         (p.kind != Kind::whole || std::trunc(value.get<double>()) == value.get<double>());
}

bool is_pair(const Json& value, const PillarParameter& p) {
  return value.is_array() && value.size() == 2 && is_number(value[0], p) && is_number(value[1], p);
}

// What the value of a parameter has to be, in words.
std::string wanted(const PillarParameter& p) {
  const std::string range = allowed_text(allowed_of(p));
  const std::string each = range == "any" ? "" : " " + range;
  switch (p.kind) {
    case Kind::number:
      return "a number" + each;
    case Kind::whole:
      return "a whole number" + each;
    case Kind::pair:
      return "a pair of numbers, each" + each;
    case Kind::points:
      break;
  }
  return "a list of points [x, y], each number" + each;
}

std::string example(const PillarParameter& p) {
  switch (p.kind) {
    case Kind::number:
    case Kind::whole:
      return "write " + wanted(p);
    case Kind::pair:
      return "write e.g. [12, 8]";
    case Kind::points:
      break;
  }
  return "write e.g. [[5, 0], [0, 5], [-5, 0]]";
}

// The numbers of one parameter; empty, and a problem, if the value does not fit.
std::vector<double> read_values(const Json& value, const PillarParameter& p, const std::string& pointer,
                                std::vector<Problem>& problems) {
  const auto fits = [&] {
    if (p.kind == Kind::number || p.kind == Kind::whole) return is_number(value, p);
    if (p.kind == Kind::pair) return is_pair(value, p);
    return value.is_array() && !value.empty() &&
           std::ranges::all_of(value, [&](const Json& item) { return is_pair(item, p); });
  };
  if (!fits()) {
    const bool scalar = value.is_number() && (p.kind == Kind::number || p.kind == Kind::whole);
    const bool outside = scalar && !in_range(value.get<double>(), allowed_of(p));
    problems.push_back({pointer, value.dump(), wanted(p),
                        outside ? nearest_advice(value.get<double>(), allowed_of(p)) : example(p)});
    return {};
  }
  if (value.is_number()) return {value.get<double>()};
  if (p.kind == Kind::pair) return value.get<std::vector<double>>();
  std::vector<double> numbers;
  for (const Json& point : value) numbers.insert(numbers.end(), {point[0], point[1]});
  return numbers;
}

std::string shape_name(const Json& json, const std::string& pointer, std::vector<Problem>& problems) {
  const auto names = pillar_shape_names();
  if (!json.is_object()) {
    problems.push_back({pointer, json.dump(), "an object", R"(write {"shape": "circle", "radius_um": 10})"});
    return {};
  }
  if (!json.contains("shape")) {
    problems.push_back({pointer + "/shape", "", "one of " + joined(names), R"(add "shape": "circle")"});
    return {};
  }
  const Json& shape = json["shape"];
  const std::string name = shape.is_string() ? shape.get<std::string>() : shape.dump();
  if (shape.is_string() && std::ranges::find(names, name) != names.end()) return name;
  problems.push_back({pointer + "/shape", shape.dump(), "one of " + joined(names),
                      "use \"" + nearest_name(name, names) + "\""});
  return {};
}

Json number_schema(const PillarParameter& p) {
  Json schema = {{"type", p.kind == Kind::whole ? "integer" : "number"}};
  const auto limit = [](double value) {
    return std::trunc(value) == value ? Json(static_cast<std::int64_t>(value)) : Json(value);
  };
  if (std::isfinite(p.minimum)) schema[p.open_minimum ? "exclusiveMinimum" : "minimum"] = limit(p.minimum);
  if (std::isfinite(p.maximum)) schema["maximum"] = limit(p.maximum);
  return schema;
}

Json value_json(const PillarParameter& p, const std::vector<double>& numbers) {
  if (p.kind == Kind::whole) return static_cast<int>(numbers.at(0));
  if (p.kind == Kind::number) return numbers.at(0);
  if (p.kind == Kind::pair) return numbers;
  Json points = Json::array();
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
    points.push_back(Json::array({numbers[k], numbers[k + 1]}));
  return points;
}

Json parameter_schema(const PillarParameter& p) {
  Json schema = {{"description", with_unit(p.doc, p.unit)}};
  const Json number = number_schema(p);
  const Json pair = {{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}};
  if (p.kind == Kind::pair) {
    schema.update(pair);
  } else if (p.kind == Kind::points) {
    schema.update(Json{{"type", "array"}, {"items", pair}, {"minItems", 3}});
  } else {
    schema.update(number);
  }
  if (p.fallback) schema["default"] = *p.fallback;
  if (!p.example.empty()) schema["examples"] = Json::array({value_json(p, p.example)});
  return schema;
}

}  // namespace

std::optional<PillarValues> read_pillar(const Json& json, const std::string& pointer,
                                        std::vector<Problem>& problems) {
  const std::size_t before = problems.size();
  PillarValues pillar{shape_name(json, pointer, problems)};
  if (pillar.shape.empty()) return std::nullopt;
  std::vector<std::string> known{"shape"};
  for (const PillarParameter& p : pillar_parameters(pillar.shape)) {
    const std::string name(p.name);
    known.push_back(name);
    if (json.contains(name)) {
      pillar.values[name] = read_values(json[name], p, pointer + "/" + name, problems);
    } else if (p.fallback) {
      pillar.values[name] = {*p.fallback};
    } else {
      problems.push_back({pointer + "/" + name, "", wanted(p) + "; it is required", "add \"" + name + "\""});
    }
  }
  for (const auto& [name, value] : json.items()) {
    if (std::ranges::find(known, name) != known.end()) continue;
    problems.push_back({pointer + "/" + name, value.dump(), "one of the names " + joined(known),
                        "did you mean \"" + nearest_name(name, known) + "\"?"});
  }
  if (problems.size() > before) return std::nullopt;
  return pillar;
}

Json pillar_json(const PillarValues& values) {
  Json json = {{"shape", values.shape}};
  for (const PillarParameter& p : pillar_parameters(values.shape)) {
    const std::string name(p.name);
    json[name] = value_json(p, values.values.at(name));
  }
  return json;
}

std::string pillar_words(const PillarValues& values, std::string (*number)(double)) {
  std::string words = values.shape;
  for (const PillarParameter& p : pillar_parameters(values.shape)) {
    const auto found = values.values.find(p.name);
    if (found == values.values.end()) continue;
    std::string name(p.name.substr(0, p.name.rfind(p.unit == "um" ? "_um" : "_deg")));
    std::ranges::replace(name, '_', ' ');
    const std::vector<double>& list = found->second;
    words += ", ";
    if (p.kind == Kind::points) {
      words += std::to_string(list.size() / 2) + " " + name;
      continue;
    }
    words += name + " " + number(list.at(0)) + (list.size() > 1 ? " and " + number(list.at(1)) : "");
    if (!p.unit.empty()) words += " " + std::string(p.unit);
  }
  return words;
}

Json pillar_schema() {
  Json alternatives = Json::array();
  for (const std::string& shape : pillar_shape_names()) {
    Json properties = {{"shape", {{"const", shape}}}};
    std::vector<std::string> required{"shape"};
    for (const PillarParameter& p : pillar_parameters(shape)) {
      properties[std::string(p.name)] = parameter_schema(p);
      if (!p.fallback) required.emplace_back(p.name);
    }
    alternatives.push_back({{"description", pillar_doc(shape)},
                            {"type", "object"},
                            {"properties", properties},
                            {"required", required},
                            {"additionalProperties", false}});
  }
  return {{"oneOf", alternatives}};
}

}  // namespace dld
