#pragma once
/// How much memory this process may still take.
#include <filesystem>
#include <optional>
#include <string>

namespace dld {

struct MemoryLimit {
  double MiB = 0;
  std::string by;  ///< what sets it, in words
};

/// The smallest of: free memory of the machine, the rest of the control group (containers, job schedulers),
/// and the limit of the address space (ulimit -v). Nothing where the system tells none of them. `root` is
/// prepended to the places /proc and /sys.
std::optional<MemoryLimit> memory_limit(const std::filesystem::path& root = "/");

}  // namespace dld
