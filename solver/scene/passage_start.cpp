#include "scene/passage_start.hpp"

#include <cmath>

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
double start_height(double x, const GapLine& gap, double half_width, const PlaneField& field) {
  const PlaneFlow flow = field.flow(gap);
  const Separation separation = separation_downstream(flow);
  if (!separation.found) return gap.middle();
  const Streamline upstream = trace_streamline(flow, separation.seed, -1, x);
  if (upstream.end != StreamlineEnd::line) return gap.middle();
  return upstream.points(upstream.points.rows() - 1, 1) + half_width;
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
    centre.y() =
        device.empty() ? gap.lower : start_height(centre.x(), gap, expected_half_width(c, shape, l), field);
  }
  Eigen::MatrixX3d x = tilted(shape, start.tilt_deg);
  x.rowwise() += centre;
  return x;
}

}  // namespace dld
