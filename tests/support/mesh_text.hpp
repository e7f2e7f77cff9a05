#pragma once
/// Meshes written as files, with all digits.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>

#include "membrane/mesh.hpp"

namespace dld::test {

inline std::string off_text(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << std::setprecision(17) << "OFF\n# a cell\n"
       << mesh.vertices.rows() << " " << mesh.faces.rows() << " 0\n";
  for (const auto& v : mesh.vertices.rowwise()) text << v(0) << " " << v(1) << " " << v(2) << "\n";
  for (const auto& f : mesh.faces.rowwise()) text << "3 " << f(0) << " " << f(1) << " " << f(2) << "\n";
  return text.str();
}

inline std::string stl_text(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << std::setprecision(17) << "solid cell\n";
  for (const auto& f : mesh.faces.rowwise()) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int v : f)
      text << "vertex " << mesh.vertices(v, 0) << " " << mesh.vertices(v, 1) << " " << mesh.vertices(v, 2)
           << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid cell\n";
  return text.str();
}

/// 80 bytes, the number of facets, and 50 bytes for each.
inline std::string stl_bytes(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto append = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(mesh.faces.rows()));
  for (const auto& f : mesh.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) append(0.0F);
    for (const int v : f) {
      for (int k = 0; k < 3; ++k) append(static_cast<float>(mesh.vertices(v, k)));
    }
    append(std::uint16_t{0});
  }
  return bytes;
}

/// A folder that goes away with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() / ("dld_mesh_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  /// The name of a case file in the folder, whether it is there or not.
  std::string case_name() const { return (path_ / "case.json").string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace dld::test
