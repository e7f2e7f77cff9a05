#pragma once
/// Where a result comes from. No time, host, user or path: equal sources give equal text.
#include <nlohmann/json.hpp>
#include <string>

namespace dld {

/// Fixed when the program was built; the text is generated into provenance.cpp by the build.
struct BuildInfo {
  std::string version, git_commit, compiler, flags, build_type, openmp, lbfgs_version, cli11_version;
};
const BuildInfo& build_info();

/// Tells this program from any other build, of the same commit too: commit, compiler, flags, and a checksum
/// over the program's own file where the system shows it.
std::string build_fingerprint();

/// {"program", "version", "git_commit", "compiler", "flags", ..., "libraries": {...}, "threads"}
nlohmann::ordered_json provenance(int threads);

}  // namespace dld
