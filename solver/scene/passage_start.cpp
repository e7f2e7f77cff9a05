#include "scene/passage_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/streamlines.hpp"
#include "membrane/mesh.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

/// Half the width (lu) that the cell will have at the pillars: a guess, from the passages at d = 2.0 um. Only
/// the number of rows until the cell is on its way depends on it.
double expected_half_width(const Case& c, const Eigen::MatrixX3d& shape, const LatticeParameters& l) {
  constexpr double softening = 0.37;
  if (!sized_by_radius(c.cell)) return -shape.col(1).minCoeff();
  return c.cell.shape == "red_blood_cell" ? l.cell_radius / (1.0 + softening * c.cell.capillary_number)
                                          : l.cell_radius;
}

/// Height of the separation streamline at x plus `half_width`, or the middle of the gap where there is none.
double start_height(double x, const GapLine& gap, double half_width, const PlaneFlow& flow) {
  const Separation separation = separation_downstream(flow);
  if (!separation.found) return gap.middle();
  const Streamline upstream = trace_streamline(flow, separation.seed, -1, x);
  if (upstream.end != StreamlineEnd::line) return gap.middle();
  return upstream.points(upstream.points.rows() - 1, 1) + half_width;
}

/// Smallest distance between a cell (vertices about its centre) with its centre at (x, y) and a pillar.
double clearance(const Eigen::MatrixX3d& cell, double x, double y, const PillarArray& pillars) {
  double smallest = std::numeric_limits<double>::max();
  for (const auto& v : cell.rowwise())
    smallest = std::min(smallest, pillars.signed_distance(x + v.x(), y + v.y()));
  return smallest;
}

/// The height y itself if the cell cuts no pillar there; else the nearest one with a lattice spacing of room,
/// or that with the most room on the line x.
double clear_height(const Eigen::MatrixX3d& cell, double x, double y, const PillarArray& pillars) {
  constexpr double step = 0.25, enough = 1.0;
  double best = y, most = clearance(cell, x, y, pillars);
  if (most >= 0) return y;
  for (double off = step; off < 0.5 * pillars.pitch_y() && most < enough; off += step) {
    for (const double height : {y + off, y - off}) {
      const double room = clearance(cell, x, height, pillars);
      if (room > most) most = room, best = height;
    }
  }
  return best;
}

}  // namespace

Eigen::MatrixX3d start_positions(const Case& c, const Eigen::MatrixX3d& shape, const Device& device,
                                 const PlaneField& field) {
  const LatticeParameters l = to_lattice(c);
  const StartParameters& start = c.cell.start;
  const GapLine gap = device.gap_line();
  Eigen::RowVector3d centre(start.x_um / l.um_per_lu, 0.0, start.z_um / l.um_per_lu);
  if (start.gap_position_um >= 0.0) {
    centre.y() = gap.lower + start.gap_position_um / l.um_per_lu;
  } else {
    centre.y() = device.empty() ? gap.lower
                                : start_height(centre.x(), gap, expected_half_width(c, shape, l),
                                               field.flow(gap, device.tilt()));
  }
  Eigen::MatrixX3d x = tilted(shape, start.tilt_deg);
  if (start.gap_position_um < 0.0 && !device.empty())
    centre.y() = clear_height(x, centre.x(), centre.y(), device.pillars());
  x.rowwise() += centre;
  return x;
}

}  // namespace dld
