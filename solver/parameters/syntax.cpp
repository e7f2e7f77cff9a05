#include "parameters/syntax.hpp"

#include <set>

namespace dld {
namespace {

// "line 3, column 5" of a byte offset (1-based, as the parser counts).
std::string place(const std::string& text, std::size_t byte) {
  std::size_t line = 1, column = 1;
  for (std::size_t i = 0; i + 1 < byte && i < text.size(); ++i) {
    column = text[i] == '\n' ? 1 : column + 1;
    line += text[i] == '\n' ? 1 : 0;
  }
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// The parser's message without its code and position: "syntax error while parsing ...".
std::string reason(const std::string& message) {
  const auto start = message.find(": ");
  return start == std::string::npos ? message : message.substr(start + 2);
}

}  // namespace

nlohmann::ordered_json parse_json(const std::string& text, std::vector<Problem>& problems) {
  using Json = nlohmann::ordered_json;
  using Event = Json::parse_event_t;
  std::vector<std::set<std::string>> names;  // of the objects that are open
  const auto watch = [&](int, Event event, Json& value) {
    if (event == Event::object_start) names.emplace_back();
    if (event == Event::object_end) names.pop_back();
    if (event == Event::key && !names.back().insert(value.get<std::string>()).second) {
      problems.push_back({"", value.dump(), "each name once", "remove the repeated name " + value.dump()});
    }
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const Json::parse_error& error) {
    problems.push_back({"", "", "JSON", place(text, error.byte) + ": " + reason(error.what())});
  } catch (const Json::exception& error) {
    problems.push_back({"", "", "JSON", reason(error.what())});
  }
  return nullptr;
}

}  // namespace dld
