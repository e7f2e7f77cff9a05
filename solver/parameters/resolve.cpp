#include "parameters/resolve.hpp"

#include <filesystem>

#include "parameters/memory.hpp"
#include "parameters/operating.hpp"
#include "parameters/reader.hpp"
#include "parameters/report.hpp"
#include "parameters/scene_rules.hpp"
#include "parameters/syntax.hpp"
#include "parameters/work.hpp"

namespace dld {

using Json = nlohmann::ordered_json;

namespace {

Json problems_json(const std::vector<Problem>& problems) {
  Json list = Json::array();
  for (const auto& p : problems) {
    list.push_back(
        {{"pointer", p.pointer}, {"value", p.value}, {"allowed", p.allowed}, {"advice", p.advice}});
  }
  return list;
}

Json warnings_json(const std::vector<Margin>& margins) {
  Json list = Json::array();
  for (const auto& m : margins) {
    if (m.ok) continue;
    list.push_back(
        {{"name", m.name}, {"value", m.value}, {"limit", m.limit}, {"unit", m.unit}, {"advice", m.advice}});
  }
  return list;
}

}  // namespace

Json resolved_json(const Json& root, const std::string& folder) {
  const Reading reading = read_tree(root, folder);
  Json answer = {{"problems", problems_json(reading.problems)}};
  if (!reading.problems.empty()) return answer;
  const Case& c = reading.c;
  const auto margins = stability_margins(c);
  answer["case"] = echo(c);
  answer["sections"] = rules_of(c.scene).sections;
  answer["warnings"] = warnings_json(margins);
  answer["expected_to_diverge"] = expected_to_diverge(margins);
  answer["memory_bytes"] = std::ceil(1024 * 1024 * memory_MiB(c));
  answer["expected_cost"] = expected_cost(c);
  answer["operating"] = operating_json(c);
  return answer;
}

Json resolve_text(const std::string& text, const std::string& name) {
  std::vector<Problem> problems;
  const Json root = parse_json(text, problems);
  if (!problems.empty()) throw CaseError(name, problems);
  const std::string folder = std::filesystem::path(name).parent_path().string();
  Json answers = Json::array();
  if (!root.is_array()) {
    answers.push_back(resolved_json(root, folder));
  } else {
    for (const Json& one : root) answers.push_back(resolved_json(one, folder));
  }
  return answers;
}

}  // namespace dld
