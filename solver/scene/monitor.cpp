#include "scene/monitor.hpp"

#include <Eigen/Geometry>
#include <cstdio>

namespace dld {
namespace {

std::string point_um(double x, double y, double z, double um_per_lu) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f) um", x * um_per_lu, y * um_per_lu, z * um_per_lu);
  return text;
}

std::string node_place(const CellView& cell, Eigen::Index vertex) {
  const auto x = cell.positions.row(vertex);
  return "membrane node " + std::to_string(vertex) + " at " + point_um(x(0), x(1), x(2), cell.um_per_lu);
}

Eigen::Index fastest_node(const Eigen::MatrixX3d& velocities) {
  Eigen::Index fastest = 0;
  double largest = -1.0;
  for (Eigen::Index i = 0; i < velocities.rows(); ++i) {
    const double speed = velocities.row(i).norm();
    if (!std::isfinite(speed)) return i;
    if (speed <= largest) continue;
    largest = speed;
    fastest = i;
  }
  return fastest;
}

/// First vertex of the face that has shrunk most.
Eigen::Index smallest_face_node(const Membrane& membrane, const Eigen::MatrixX3d& x) {
  const auto& faces = membrane.reference().faces;
  const auto twice_area = [&](const Eigen::MatrixX3d& p, Eigen::Index f) {
    const Eigen::RowVector3d a = p.row(faces(f, 1)) - p.row(faces(f, 0));
    const Eigen::RowVector3d b = p.row(faces(f, 2)) - p.row(faces(f, 0));
    return a.cross(b).norm();
  };
  Eigen::Index smallest = 0;
  double least = HUGE_VAL;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const double ratio = twice_area(x, f) / twice_area(membrane.reference().vertices, f);
    if (ratio >= least) continue;
    least = ratio;
    smallest = f;
  }
  return faces(smallest, 0);
}

Eigen::Index nearest_to_pillar(const CellView& cell) {
  Eigen::Index nearest = 0;
  double film = HUGE_VAL;
  for (Eigen::Index i = 0; cell.pillars && i < cell.positions.rows(); ++i) {
    const double h = cell.pillars->signed_distance(cell.positions(i, 0), cell.positions(i, 1));
    if (h >= film) continue;
    film = h;
    nearest = i;
  }
  return nearest;
}

/// The cell against what surrounds it.
std::optional<Failure> check_contact(const CellView& cell, const MonitorLimits& limits) {
  if (!(cell.film > -limits.penetration)) {
    return Failure{"penetration of a pillar", -cell.film, limits.penetration,
                   node_place(cell, nearest_to_pillar(cell)),
                   "raise /coupling/pillar_repulsion, or refine /fluid/lattice_spacing_um"};
  }
  return std::nullopt;
}

}  // namespace

void report_failure(const Failure& failure, long step, nlohmann::ordered_json& summary) {
  summary["failing_quantity"] = failure.quantity;
  summary["failing_value"] = std::isfinite(failure.value) ? nlohmann::ordered_json(failure.value) : nullptr;
  summary["failing_limit"] = failure.limit;
  summary["failing_step"] = step;
  summary["failing_place"] = failure.place;
  summary["advice"] = failure.advice;
}

double smallest_wall_gap(const Eigen::MatrixX3d& positions, double wall_height) {
  return wall_height - positions.col(2).cwiseAbs().maxCoeff();
}

std::string fluid_place(const UnitCell& cell, std::array<int, 3> node, double um_per_lu) {
  return "fluid node at " +
         point_um(node[0] + cell.origin_x, node[1] + cell.origin_y, node[2] + cell.origin_z, um_per_lu);
}

std::optional<Failure> check_membrane(const CellView& cell, const MonitorLimits& limits) {
  const double volume_change = cell.state.volume / cell.membrane.reference_volume() - 1.0;
  const double area_change = cell.state.area / cell.membrane.reference_area() - 1.0;
  // Written as !(good) so that NaN counts as failed.
  if (!(cell.speed < limits.speed)) {
    const bool finite = std::isfinite(cell.speed);
    return Failure{finite ? "speed of the membrane" : "membrane is not a number", cell.speed, limits.speed,
                   node_place(cell, fastest_node(cell.velocities)),
                   "lower /fluid/force_density: the membrane is too stiff for explicit coupling"};
  }
  if (!(std::abs(volume_change) < limits.volume_change)) {
    return Failure{"volume of the cell", volume_change, limits.volume_change,
                   node_place(cell, fastest_node(cell.velocities)),
                   "set /cell/volume_control to projection, or raise /cell/volume_modulus"};
  }
  if (!(std::abs(area_change) < limits.area_change)) {
    return Failure{"area of the cell", area_change, limits.area_change,
                   node_place(cell, fastest_node(cell.velocities)),
                   "raise /cell/global_area_modulus and /cell/local_area_modulus"};
  }
  if (!(cell.state.min_face_ratio > limits.face_ratio)) {
    return Failure{"smallest face of the membrane", cell.state.min_face_ratio, limits.face_ratio,
                   node_place(cell, smallest_face_node(cell.membrane, cell.positions)),
                   "use /coupling/regularisation tangential with /coupling/kernel phi4, or a coarser "
                   "/cell/mesh_frequency"};
  }
  return check_contact(cell, limits);
}

}  // namespace dld
