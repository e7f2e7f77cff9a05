#pragma once
/// Triangle meshes from files: OFF (text) and STL (text or binary).
///
/// The reader is our own because the libraries that read these files (CGAL, Assimp) weigh tens of MB and
/// repair in silence what a cell must not have.
#include <filesystem>
#include <stdexcept>
#include <string>

#include "membrane/mesh.hpp"

namespace dld {

/// A file that is no mesh; what() says where and why, in words without the file's name.
struct MeshFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The mesh of a file, in the unit of the file; its kind goes by the extension, .off or .stl. Faces of more
/// than three corners are refused. Corners of an STL file that have the very same coordinates are one vertex.
/// Nothing is checked but the file: see mesh_faults(). Throws MeshFileError.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace dld
