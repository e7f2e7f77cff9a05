#include "output/verify.hpp"

#include <algorithm>

#include "output/hdf5_file.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const std::filesystem::path& path) {
  const std::vector<char> bytes = read_bytes(path);
  return {bytes.begin(), bytes.end()};
}

void compare_summary(const std::filesystem::path& run, const std::filesystem::path& path, const Json& kept,
                     std::vector<std::string>& problems) {
  const Json given = Json::parse(text_of(path), nullptr, false);
  if (!given.is_object()) {
    problems.push_back(path.string() + " is empty or no JSON object");
  } else if (given != kept) {
    problems.push_back(path.string() + " is not the summary in " + run.string() +
                       ": it was changed, or is of another run");
  }
}

}  // namespace

std::vector<std::string> verify_run(const std::filesystem::path& run,
                                    const std::optional<std::filesystem::path>& summary,
                                    const std::optional<Json>& resolved_case) {
  std::vector<std::string> problems;
  try {
    const std::string broken = run.string() + " has changed since it was written: its seal is broken";
    if (Hdf5File::seal_broken(run)) return {broken};
    const bool whole = Hdf5File::seal_holds(run);
    const Hdf5Reader file(run);
    const auto names = file.text_attributes("/");
    const bool sealed = std::find(names.begin(), names.end(), seal_attribute) != names.end();
    if (sealed && !whole) problems.push_back(broken);
    if (summary) compare_summary(run, *summary, Json::parse(file.text_attribute("/", "summary")), problems);
    if (resolved_case && Json::parse(file.text_attribute("/", "case")) != *resolved_case)
      problems.push_back(run.string() + " is of another case");
  } catch (const IoError& error) {
    problems.emplace_back(error.what());
  } catch (const Json::exception&) {
    problems.push_back(run.string() + " has changed since it was written: its attributes are no JSON");
  }
  return problems;
}

}  // namespace dld
