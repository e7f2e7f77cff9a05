#include "output/memory_limit.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

namespace dld {
namespace {

constexpr double bytes_per_MiB = 1024.0 * 1024.0;

/// The number that a file begins with; nothing for "max" or without the file.
std::optional<double> number_in(const std::filesystem::path& path) {
  std::ifstream file(path);
  double value = 0;
  return file >> value ? std::optional(value) : std::nullopt;
}

void add_free_memory(const std::filesystem::path& root, std::vector<MemoryLimit>& limits) {
  std::ifstream file(root / "proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    double kib = 0;
    std::string name;
    if (std::istringstream(line) >> name >> kib && name == "MemAvailable:")
      limits.push_back({kib / 1024.0, "free memory of the machine"});
  }
}

/// Every group from the process's own up to the root can have a limit.
void add_group(const std::filesystem::path& group, const std::filesystem::path& top, const char* limit_file,
               const char* usage_file, std::vector<MemoryLimit>& limits) {
  for (std::filesystem::path folder = group;; folder = folder.parent_path()) {
    const auto limit = number_in(folder / limit_file), used = number_in(folder / usage_file);
    // Version 1 writes a number near 2^63 for "no limit".
    if (limit && *limit < 1e18)
      limits.push_back({std::max(0.0, *limit - used.value_or(0.0)) / bytes_per_MiB,
                        "rest of the memory limit of the control group"});
    if (folder == top || folder == folder.parent_path()) break;
  }
}

void add_control_groups(const std::filesystem::path& root, std::vector<MemoryLimit>& limits) {
  std::ifstream file(root / "proc/self/cgroup");
  const std::filesystem::path top = root / "sys/fs/cgroup";
  // "hierarchy:controllers:/path"; version 2 has no controllers.
  for (std::string line; std::getline(file, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const std::filesystem::path inner = std::filesystem::path(line.substr(second + 1)).relative_path();
    if (controllers.empty())
      add_group((top / inner).lexically_normal(), top, "memory.max", "memory.current", limits);
    if (controllers == "memory")
      add_group((top / "memory" / inner).lexically_normal(), top / "memory", "memory.limit_in_bytes",
                "memory.usage_in_bytes", limits);
  }
}

}  // namespace

std::optional<MemoryLimit> memory_limit(const std::filesystem::path& root) {
  std::vector<MemoryLimit> limits;
  add_free_memory(root, limits);
  add_control_groups(root, limits);
  rlimit space{};
  if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
    limits.push_back({static_cast<double>(space.rlim_cur) / bytes_per_MiB, "limit of the address space"});
  std::optional<MemoryLimit> smallest;
  for (const MemoryLimit& limit : limits) {
    if (!smallest || limit.MiB < smallest->MiB) smallest = limit;
  }
  return smallest;
}

}  // namespace dld
