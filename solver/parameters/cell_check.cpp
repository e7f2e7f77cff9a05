#include "parameters/cell_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "membrane/mesh_check.hpp"
#include "membrane/stretching.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/text.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

using Problems = std::vector<Problem>;

// Mean edge / dx: fluid leaks through a coarser mesh, the kernel does not see the modes of a finer one; and
// the longest edge, beyond which single faces leak.
constexpr double shortest_mean_edge = 0.5, longest_mean_edge = 1.5, longest_edge = 2.0;

// Half the largest thickness of the red blood cell shape, in units of its radius.
constexpr double half_thickness_ratio = 0.33;

Eigen::MatrixX3d vertices_um(const CellParameters& cell) {
  return cell_mesh(cell, cell.radius_um).vertices;
}

}  // namespace

HeightRange height_range_um(const CellParameters& cell) {
  if (!sized_by_radius(cell)) {
    const Eigen::MatrixX3d x = tilted(vertices_um(cell), cell.start.tilt_deg);
    return {x.col(2).minCoeff(), x.col(2).maxCoeff()};
  }
  const double tilt = cell.start.tilt_deg * std::numbers::pi / 180;
  // Of the red cell an upper bound: that of the box about it.
  const double share = cell.shape == "sphere"
                           ? 1.0
                           : std::abs(std::sin(tilt)) + half_thickness_ratio * std::abs(std::cos(tilt));
  return {-cell.radius_um * share, cell.radius_um * share};
}

double reach_um(const CellParameters& cell) {
  if (sized_by_radius(cell)) return cell.radius_um;
  return vertices_um(cell).rowwise().norm().maxCoeff();
}

void check_width(const Case& c, Problems& problems) {
  if (sized_by_radius(c.cell)) return;
  if (c.geometry.pillar && !pillar_problems(*c.geometry.pillar).empty()) return;
  const double gap_um = device_um(c).gap();
  const Eigen::MatrixX3d x = vertices_um(c.cell);
  const Eigen::RowVector3d width_um = x.colwise().maxCoeff() - x.colwise().minCoeff();
  if (std::min(width_um.x(), width_um.y()) < gap_um) return;
  problems.push_back({size_pointer(c.cell), size_text(c.cell),
                      "a cell that is narrower, along x or y, than the gap of " + number_text(gap_um) + " um",
                      "use a smaller cell, or a larger /geometry/pitch_um"});
}

void check_mirror(const Case& c, bool half_height, Problems& problems) {
  if (!half_height || mirror_symmetric(c.cell)) return;
  problems.push_back(
      {size_pointer(c.cell), size_text(c.cell),
       "a mesh whose vertices and faces are their own mirror images about z = 0, since half the "
       "height is simulated",
       c.scene == "passage" ? "use \"full\" for /geometry/height, or a symmetric mesh"
                            : "use a symmetric mesh, or \"static\" for /stretching/method"});
}

void check_edges(const Case& c, Problems& problems) {
  if (c.cell.shape != "mesh") return;
  const double dx = c.fluid.lattice_spacing_um;
  const EdgeLengths edges = edge_lengths(cell_mesh(c.cell, c.cell.radius_um));
  if (edges.mean < shortest_mean_edge * dx || edges.mean > longest_mean_edge * dx) {
    problems.push_back(
        {size_pointer(c.cell),
         size_text(c.cell) + " with a mean edge of " + number_text(edges.mean / dx) + " lattice spacings",
         "between " + number_text(shortest_mean_edge) + " and " + number_text(longest_mean_edge),
         "mesh it with edges of about " + number_text(dx) +
             " um, or use a /fluid/lattice_spacing_um of about " +
             number_text(std::round(1000 * edges.mean) / 1000)});
  } else if (edges.longest > longest_edge * dx) {
    problems.push_back(
        {size_pointer(c.cell),
         size_text(c.cell) + " with an edge of " + number_text(edges.longest / dx) + " lattice spacings",
         "edges of at most " + number_text(longest_edge) + " lattice spacings",
         "mesh it more evenly, with edges of about " + number_text(dx) + " um"});
  }
}

void check_patches(const Case& c, Problems& problems) {
  const Eigen::MatrixX3d x = vertices_um(c.cell);
  bool hold = c.stretching.contact_radius_um < (x.col(0).maxCoeff() - x.col(0).minCoeff()) / 2;
  try {
    const ContactPatches patches(x, c.stretching.contact_radius_um);
  } catch (const std::invalid_argument&) {
    hold = false;
  }
  if (hold) return;
  problems.push_back(
      {"/stretching/contact_radius_um", number_text(c.stretching.contact_radius_um),
       "a vertex of the mesh within it at either tip, and less than half the length of the cell",
       "use about twice the mean edge, " +
           number_text(2 * edge_lengths(cell_mesh(c.cell, c.cell.radius_um)).mean) + " um"});
}

}  // namespace dld
