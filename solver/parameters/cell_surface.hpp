#pragma once
/// The surface of the cell that a case describes, and what is asked about its size.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "membrane/mesh.hpp"
#include "parameters/case.hpp"

namespace dld {

struct Problem;

/// A mesh from a file that passed all checks.
struct CellSurface {
  TriangleMesh mesh_um;           ///< its centre, the mean of the vertices, is the origin
  bool mirror_symmetric = false;  ///< about z = 0; then to the last bit
};

/// Names of all cell shapes: those that a radius describes, and those that have parameters of their own.
std::vector<std::string> all_cell_shape_names();

/// Whether radius_um alone sizes the shape. The others have a size of their own, and radius_um is the scale r
/// of Ca and of the moduli only.
bool sized_by_radius(const CellParameters& cell);

/// Completes a cell whose shape has parameters of its own: reads the mesh (relative to `directory`), and
/// takes the largest radius in the plane as r where the case, `given`, has no radius_um.
void complete_cell(const nlohmann::ordered_json& given, const std::string& directory, CellParameters& cell,
                   std::vector<Problem>& problems);

/// The stress-free surface in the unit in which r is `radius`.
TriangleMesh cell_mesh(const CellParameters& cell, double radius);

/// Whether it is its own mirror image about z = 0 before it is tilted.
bool mirror_symmetric(const CellParameters& cell);

/// Largest distance of the surface to the z axis, um.
double in_plane_radius_um(const CellParameters& cell);

/// Largest distance of the surface from a plane x = 0, y = 0 or z = 0, um; r of a shape that r describes.
double half_box_um(const CellParameters& cell);

/// Where the size stands: "/cell/radius_um", "/cell/semi_axes_um" or "/cell/mesh_file".
std::string size_pointer(const CellParameters& cell);
/// What stands there.
std::string size_text(const CellParameters& cell);

Eigen::Index face_count(const CellParameters& cell);

}  // namespace dld
