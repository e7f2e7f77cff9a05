#include "scene/flow_output.hpp"

#include <cmath>
#include <vector>

#include "parameters/flow_estimate.hpp"
#include "parameters/operating.hpp"

namespace dld {
namespace {

struct Node {
  Eigen::Index i, j;
};

/// Node (i, j) of the unit cell that node (a, b) of the unbounded lattice repeats: phi(x + nx, y) = phi(x, y
/// - d).
Node in_unit_cell(const PlaneField& field, long a, long b) {
  const long nx = field.nx(), ny = field.ny();
  const long column = a >= 0 ? a / nx : -((nx - 1 - a) / nx);
  const long y = (b - column * field.row_shift()) % ny;
  return {a - column * nx, y < 0 ? y + ny : y};
}

void write_around(RunContext& context, const PlaneField& field, const PhysicalScales& scales,
                  const Eigen::Vector2d& centre) {
  const long nx = field.nx(), ny = field.ny();
  const long a0 = std::lround(centre.x() - field.x0()) - nx / 2;
  const long b0 = std::lround(centre.y() - field.y0()) - ny / 2;
  const auto n = static_cast<std::size_t>(nx * ny), n_quads = static_cast<std::size_t>((nx - 1) * (ny - 1));
  std::vector<double> points, velocity;
  std::vector<std::uint8_t> solid;
  std::vector<std::int32_t> quads;
  points.reserve(3 * n), velocity.reserve(3 * n), solid.reserve(n), quads.reserve(4 * n_quads);
  for (long i = 0; i < nx; ++i) {
    for (long j = 0; j < ny; ++j) {
      const Node node = in_unit_cell(field, a0 + i, b0 + j);
      points.insert(points.end(), {(static_cast<double>(a0 + i) + field.x0()) * scales.um,
                                   (static_cast<double>(b0 + j) + field.y0()) * scales.um, 0.0});
      velocity.insert(velocity.end(), {field.u()(node.i, node.j) * scales.velocity_mm_s,
                                       field.v()(node.i, node.j) * scales.velocity_mm_s, 0.0});
      solid.push_back(field.solid()(node.i, node.j));
      if (i + 1 == nx || j + 1 == ny) continue;
      const auto first = static_cast<std::int32_t>(i * ny + j), right = first + static_cast<std::int32_t>(ny);
      quads.insert(quads.end(), {first, right, right + 1, first + 1});
    }
  }
  const std::string group = "/flow/around/";
  context.out.write(group + "points_um", std::span<const double>(points), {n, 3}, "um",
                    "positions (x, y, 0) of the nodes, around the cell where there is one");
  context.out.write(group + "quads", std::span<const std::int32_t>(quads), {n_quads, 4}, "none",
                    "nodes of each quadrilateral");
  context.out.write(group + "velocity_mm_per_s", std::span<const double>(velocity), {n, 3}, "mm/s",
                    "velocity (u_x, u_y, 0) on the mid plane");
  context.out.write(group + "solid", solid, "none", "1 on the nodes inside a pillar");
  context.xdmf.fixed.push_back(
      {.name = "flow",
       .points = group + "points_um",
       .cells = group + "quads",
       .n_points = n,
       .n_cells = n_quads,
       .corners = 4,
       .fields = {{.name = "velocity_mm_per_s", .dataset = group + "velocity_mm_per_s", .components = 3},
                  {.name = "solid", .dataset = group + "solid", .number = XdmfField::Number::uint8}}});
}

}  // namespace

void write_plane_flow(RunContext& context, const PlaneField& field, const PhysicalScales& scales,
                      const Eigen::Vector2d& centre) {
  const auto nx = static_cast<std::size_t>(field.nx()), ny = static_cast<std::size_t>(field.ny());
  std::vector<double> x_um(nx), y_um(ny), velocity(nx * ny * 2), points;
  std::vector<std::uint8_t> solid(nx * ny);
  for (std::size_t i = 0; i < nx; ++i) x_um[i] = (static_cast<double>(i) + field.x0()) * scales.um;
  for (std::size_t j = 0; j < ny; ++j) y_um[j] = (static_cast<double>(j) + field.y0()) * scales.um;
  for (std::size_t i = 0; i < nx; ++i) {
    for (std::size_t j = 0; j < ny; ++j) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      velocity[(i * ny + j) * 2] = field.u()(a, b);
      velocity[(i * ny + j) * 2 + 1] = field.v()(a, b);
      solid[i * ny + j] = field.solid()(a, b);
      points.insert(points.end(), {x_um.front() + static_cast<double>(i) * scales.um,
                                   y_um.front() + static_cast<double>(j) * scales.um, 0.0});
    }
  }
  context.out.write("/flow/x_um", x_um, "um", "x of the nodes, relative to the pillar's centre");
  context.out.write("/flow/y_um", y_um, "um", "y of the nodes, relative to the pillar's centre");
  context.out.write("/flow/velocity", std::span<const double>(velocity), {nx, ny, 2}, "lu",
                    "in-plane velocity (u_x, u_y) on the mid plane");
  context.out.physical("/flow/velocity", "mm/s", scales.velocity_mm_s);
  context.out.write("/flow/solid", std::span<const std::uint8_t>(solid), {nx, ny}, "none",
                    "1 on the nodes inside the pillar");
  context.out.write("/flow/points_um", std::span<const double>(points), {nx, ny, 3}, "um",
                    "node positions (x, y, 0) relative to the pillar centre");
  write_around(context, field, scales, centre);
}

void summarise_mean_flow(const Case& c, double along, double across, nlohmann::ordered_json& summary) {
  const double epsilon = c.geometry.epsilon();
  const double share = epsilon > 0 ? across / along / epsilon : 0;
  if (share > lateral_share_limit) {
    summary["lateral_share_of_epsilon"] = share;
    summary["separation_over_blocked"] = separation_ratio(epsilon, share);
  }
  if (operating_given(c)) summary["operating"] = operating_summary(c, along);
}

}  // namespace dld
