#include "parameters/flow_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/pillar_array.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

Mobility solved(const GeometryParameters& g) {
  const PillarArray pillars(make_pillar(g.pillar_shape, {g.pillar_radius_um}), g.pitch_um, g.pitch_um,
                            g.row_shift_um);
  if (pillars.empty()) return slit_mobility(g.depth_um);
  return estimate_mobility(
      {.pitch_x = g.pitch_um,
       .pitch_y = g.pitch_um,
       .row_shift = g.row_shift_um,
       .depth = g.depth_um,
       .gap = g.pitch_um - 2 * g.pillar_radius_um,
       .distance = [&pillars](double x, double y) { return pillars.signed_distance(x, y); }});
}

// Width next to a wall, in units of the gap, that carries the share `epsilon` of a parabola: 3 t^2 - 2 t^3.
double parabola(double epsilon) {
  return 0.5 - std::sin(std::asin(1 - 2 * epsilon) / 3);
}

}  // namespace

const Mobility& device_mobility_um2(const Case& c) {
  const auto& g = c.geometry;
  using Key = std::tuple<std::string, double, double, double, double>;
  thread_local std::map<Key, Mobility> known;
  const Key key{g.pillar_shape, g.pillar_radius_um, g.pitch_um, g.row_shift_um, g.depth_um};
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(key, solved(g)).first->second;
}

bool is_shallow(const Case& c) {
  const auto& g = c.geometry;
  return g.pillar_shape == "none" || g.depth_um <= 0.5 * (g.pitch_um - 2 * g.pillar_radius_um);
}

FlowEstimate estimate_flow(const Case& c) {
  const double dx = c.fluid.lattice_spacing_um;
  const LatticeParameters l = to_lattice(c);
  const Mobility& m = device_mobility_um2(c);
  const double force = l.force_density / (l.viscosity * dx * dx);
  const double epsilon = c.geometry.row_shift_um / c.geometry.pitch_um;
  const bool blocked = c.fluid.lateral_flow == "blocked";
  FlowEstimate flow;
  flow.mean_speed = force * (blocked ? m.blocked() : m.xx);
  flow.largest_speed = force * m.largest;
  flow.settling_time = m.xx / (l.viscosity * dx * dx);
  flow.lateral_share = blocked || epsilon == 0 ? 0 : m.lateral_ratio() / epsilon;
  return flow;
}

double lateral_friction(const Case& c) {
  const LatticeParameters l = to_lattice(c);
  if (is_shallow(c)) return 1.5 * 12.0 * l.viscosity / (l.depth * l.depth);
  // Of narrow gaps momentum is gone within some steps; a control of every 20 steps must not be faster than
  // that.
  constexpr double fastest = 0.05;
  const double dx = c.fluid.lattice_spacing_um;
  return std::min(fastest, l.viscosity * dx * dx / device_mobility_um2(c).yy);
}

double separation_ratio(double epsilon, double share) {
  if (epsilon <= 0 || epsilon >= 1) return 1;
  return parabola(std::clamp(epsilon * (1 - share), 0.0, 1.0)) / parabola(epsilon);
}

}  // namespace dld
