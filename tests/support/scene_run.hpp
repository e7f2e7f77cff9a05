#pragma once
/// Runs a scene and keeps its summary; the output file is never completed and leaves nothing behind.
#include <unistd.h>

#include <filesystem>

#include "parameters/reader.hpp"
#include "scene/registry.hpp"

namespace dld::test {

struct SceneResult {
  Status status = Status::undecided;
  nlohmann::ordered_json summary;
};

inline SceneResult run_scene(const Case& c) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("dld_test_" + std::to_string(::getpid()) + "_" + c.scene + ".h5");
  Hdf5File out(path);
  std::FILE* nowhere = std::fopen("/dev/null", "w");
  Progress progress(nowhere, false);
  RunContext context{
      .out = out, .progress = progress, .checkpoint = path.string() + ".checkpoint", .resume = false};
  const Status status = find_scene(c.scene)(c, context);
  std::filesystem::remove(context.checkpoint);
  std::fclose(nowhere);
  return {status, context.summary};
}

/// The case that a text describes, with all defaults; throws CaseError for a bad one.
inline Case case_of(const std::string& text) {
  return parse_case(text, "test");
}

}  // namespace dld::test
