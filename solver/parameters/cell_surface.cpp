#include "parameters/cell_surface.hpp"

#include <algorithm>
#include <filesystem>

#include "membrane/mesh_check.hpp"
#include "membrane/mesh_file.hpp"
#include "parameters/reader.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

using Problems = std::vector<Problem>;

// Coordinates of a mesh file are rounded: an image this near, in units of the radius, is the mirror image.
constexpr double mirror_tolerance = 1e-5;

Eigen::RowVector3d semi_axes_um(const CellParameters& cell) {
  return {cell.semi_axes_um[0], cell.semi_axes_um[1], cell.semi_axes_um[2]};
}

void require_semi_axes(const nlohmann::ordered_json& given, const CellParameters& cell, Problems& problems) {
  // Axes that are given wrongly are a problem that was found before.
  if (!cell.semi_axes_um.empty() ||
      given.contains(nlohmann::ordered_json::json_pointer("/cell/semi_axes_um")))
    return;
  problems.push_back({"/cell/semi_axes_um", "", "three semi-axes, along x, y and z, of the shape ellipsoid",
                      "add e.g. \"semi_axes_um\": [4, 3, 1.5]"});
}

void read_surface(const nlohmann::ordered_json& given, const std::filesystem::path& directory,
                  CellParameters& cell, Problems& problems) {
  const std::string value = nlohmann::json(cell.mesh_file).dump();
  if (cell.mesh_file.empty()) {
    if (given.contains(nlohmann::ordered_json::json_pointer("/cell/mesh_file"))) return;
    problems.push_back({"/cell/mesh_file", "", "a file, .off or .stl, of the shape mesh",
                        "add e.g. \"mesh_file\": \"cell.off\", relative to the case file"});
    return;
  }
  CellSurface surface;
  try {
    surface.mesh_um = read_mesh(directory / cell.mesh_file);
  } catch (const MeshFileError& error) {
    problems.push_back(
        {"/cell/mesh_file", value, "a mesh in OFF or STL, relative to the case file", error.what()});
    return;
  }
  const auto faults = mesh_faults(surface.mesh_um);
  for (const MeshFault& fault : faults)
    problems.push_back({"/cell/mesh_file", value + " with " + fault.found, fault.allowed, fault.advice});
  if (!faults.empty()) return;
  centre_mesh(surface.mesh_um);
  surface.mirror_symmetric =
      make_mirror_symmetric(surface.mesh_um, mirror_tolerance * radius_in_plane(surface.mesh_um));
  cell.surface = std::make_shared<const CellSurface>(std::move(surface));
}

}  // namespace

std::vector<std::string> all_cell_shape_names() {
  auto names = cell_shape_names();
  names.insert(names.end(), {"ellipsoid", "mesh"});
  return names;
}

bool sized_by_radius(const CellParameters& cell) {
  return cell.shape != "ellipsoid" && cell.shape != "mesh";
}

void complete_cell(const nlohmann::ordered_json& given, const std::string& directory, CellParameters& cell,
                   Problems& problems) {
  if (sized_by_radius(cell)) return;
  const std::size_t before = problems.size();
  if (cell.shape == "ellipsoid") require_semi_axes(given, cell, problems);
  if (cell.shape == "mesh") read_surface(given, directory, cell, problems);
  const nlohmann::ordered_json::json_pointer radius("/cell/radius_um");
  const bool complete = problems.size() == before && (cell.surface || !cell.semi_axes_um.empty());
  if (complete && !given.contains(radius)) cell.radius_um = in_plane_radius_um(cell);
}

TriangleMesh cell_mesh(const CellParameters& cell, double radius) {
  if (sized_by_radius(cell)) return make_cell(cell.shape, cell.mesh_frequency, radius);
  const double scale = radius / cell.radius_um;
  if (cell.shape == "ellipsoid") return ellipsoid(cell.mesh_frequency, scale * semi_axes_um(cell));
  TriangleMesh mesh = cell.surface->mesh_um;
  mesh.vertices *= scale;
  return mesh;
}

bool mirror_symmetric(const CellParameters& cell) {
  return cell.shape != "mesh" || cell.surface->mirror_symmetric;
}

double in_plane_radius_um(const CellParameters& cell) {
  if (cell.shape == "ellipsoid") return std::max(cell.semi_axes_um[0], cell.semi_axes_um[1]);
  if (cell.shape == "mesh") return radius_in_plane(cell.surface->mesh_um);
  return cell.radius_um;
}

double half_box_um(const CellParameters& cell) {
  return sized_by_radius(cell) ? cell.radius_um
                               : cell_mesh(cell, cell.radius_um).vertices.cwiseAbs().maxCoeff();
}

Eigen::Index face_count(const CellParameters& cell) {
  if (cell.surface) return cell.surface->mesh_um.faces.rows();
  return 20 * static_cast<Eigen::Index>(cell.mesh_frequency) * cell.mesh_frequency;
}

std::string size_pointer(const CellParameters& cell) {
  if (cell.shape == "ellipsoid") return "/cell/semi_axes_um";
  return cell.shape == "mesh" ? "/cell/mesh_file" : "/cell/radius_um";
}

std::string size_text(const CellParameters& cell) {
  if (cell.shape == "ellipsoid") return nlohmann::json(cell.semi_axes_um).dump();
  return cell.shape == "mesh" ? nlohmann::json(cell.mesh_file).dump() : number_text(cell.radius_um);
}

}  // namespace dld
