#pragma once
/// Whether the files of a finished run are what the solver wrote and belong together.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace dld {

/// What is wrong with a finished HDF5 file, with its summary (JSON), and with the resolved case that it is
/// said to belong to; empty if nothing is. Files of versions that did not seal them are judged by what they
/// hold.
std::vector<std::string> verify_run(const std::filesystem::path& run,
                                    const std::optional<std::filesystem::path>& summary,
                                    const std::optional<nlohmann::ordered_json>& resolved_case);

}  // namespace dld
