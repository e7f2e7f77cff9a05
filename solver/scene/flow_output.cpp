#include "scene/flow_output.hpp"

#include <vector>

#include "parameters/flow_estimate.hpp"
#include "parameters/operating.hpp"

namespace dld {

void write_plane_flow(RunContext& context, const PlaneField& field, double um_per_lu) {
  const auto nx = static_cast<std::size_t>(field.nx()), ny = static_cast<std::size_t>(field.ny());
  std::vector<double> x_um(nx), y_um(ny), velocity(nx * ny * 2);
  std::vector<std::uint8_t> solid(nx * ny);
  for (std::size_t i = 0; i < nx; ++i) x_um[i] = (static_cast<double>(i) + field.x0()) * um_per_lu;
  for (std::size_t j = 0; j < ny; ++j) y_um[j] = (static_cast<double>(j) + field.y0()) * um_per_lu;
  for (std::size_t i = 0; i < nx; ++i) {
    for (std::size_t j = 0; j < ny; ++j) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      velocity[(i * ny + j) * 2] = field.u()(a, b);
      velocity[(i * ny + j) * 2 + 1] = field.v()(a, b);
      solid[i * ny + j] = field.solid()(a, b);
    }
  }
  context.out.write("/flow/x_um", x_um, "um", "x of the nodes, relative to the pillar's centre");
  context.out.write("/flow/y_um", y_um, "um", "y of the nodes, relative to the pillar's centre");
  context.out.write("/flow/velocity", std::span<const double>(velocity), {nx, ny, 2}, "lu",
                    "in-plane velocity (u_x, u_y) on the mid plane, lattice units");
  context.out.write("/flow/solid", std::span<const std::uint8_t>(solid), {nx, ny}, "1",
                    "1 on the nodes inside the pillar");
  context.xdmf.flow = XdmfFlow{nx, ny, x_um.front(), y_um.front(), um_per_lu, 8};
}

void summarise_mean_flow(const Case& c, double mean_velocity, double lateral_velocity,
                         nlohmann::ordered_json& summary) {
  const double epsilon = c.geometry.row_shift_um / c.geometry.pitch_um;
  const double share = epsilon > 0 ? lateral_velocity / mean_velocity / epsilon : 0;
  if (share > lateral_share_limit) {
    summary["lateral_share_of_epsilon"] = share;
    summary["separation_over_blocked"] = separation_ratio(epsilon, share);
  }
  if (operating_given(c)) summary["operating"] = operating_summary(c, mean_velocity);
}

}  // namespace dld
