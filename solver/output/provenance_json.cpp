#include <hdf5.h>

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "output/durable_file.hpp"
#include "output/provenance.hpp"

namespace dld {
namespace {

std::string version_text(unsigned major, unsigned minor, unsigned patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

std::string build_fingerprint() {
  static const std::string text = [] {
    const BuildInfo& build = build_info();
    std::string all = build.git_commit + " " + build.compiler + " " + build.flags;
    std::error_code none;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
    if (!none) all += " " + std::to_string(checksum(read_bytes(program)));
    return all;
  }();
  return text;
}

nlohmann::ordered_json provenance(int threads) {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  const BuildInfo& build = build_info();
  return {{"program", "dld"},
          {"version", build.version},
          {"git_commit", build.git_commit},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"build_type", build.build_type},
          {"openmp", build.openmp},
          {"libraries",
           {{"eigen", version_text(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
            {"hdf5", version_text(major, minor, release)},
            {"nlohmann_json", version_text(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                           NLOHMANN_JSON_VERSION_PATCH)},
            {"cli11", build.cli11_version},
            {"liblbfgs", build.lbfgs_version}}},
          {"threads", threads}};
}

}  // namespace dld
