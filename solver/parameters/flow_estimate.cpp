#include "parameters/flow_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/device.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

// The same mobility for forces along and across the driving force.
Mobility along_drive(const Mobility& m, const std::array<double, 2>& drive) {
  const auto [cosine, sine] = drive;
  const double mean = cosine * cosine * m.xx + sine * sine * m.yy, mixed = cosine * sine * (m.yy - m.xx);
  Mobility turned = m;
  turned.xx = mean + cosine * sine * (m.xy + m.yx);
  turned.yy = m.xx + m.yy - turned.xx;
  turned.xy = cosine * cosine * m.xy - sine * sine * m.yx + mixed;
  turned.yx = cosine * cosine * m.yx - sine * sine * m.xy + mixed;
  return turned;
}

Mobility solved(const Case& c) {
  const Device device = device_um(c);
  if (device.empty()) return slit_mobility(device.depth());
  const PillarArray& pillars = device.pillars();
  const Mobility m = estimate_mobility(
      {.pitch_x = pillars.pitch_x(),
       .pitch_y = pillars.pitch_y(),
       .row_shift = pillars.row_shift(),
       .depth = device.depth(),
       .gap = device.narrowest_gap(),
       .distance = [&pillars](double x, double y) { return pillars.signed_distance(x, y); }});
  Mobility turned = along_drive(m, device.drive());
  turned.open_area = device.open_area() / (pillars.pitch_x() * pillars.pitch_y());
  return turned;
}

// Width next to a wall, in units of the gap, that carries the share `epsilon` of a parabola: 3 t^2 - 2 t^3.
double parabola(double epsilon) {
  return 0.5 - std::sin(std::asin(1 - 2 * epsilon) / 3);
}

}  // namespace

const Mobility& device_mobility_um2(const Case& c) {
  const auto& g = c.geometry;
  const PillarValues pillar = g.pillar_values();
  using Key = std::tuple<std::string, decltype(pillar.values), double, double, double, double, bool>;
  thread_local std::map<Key, Mobility> known;
  const Key key{pillar.shape,   pillar.values, g.pitch_um,        g.pitch_across_um(),
                g.row_shift_um, g.depth_um,    g.rotated_square()};
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(key, solved(c)).first->second;
}

bool is_shallow(const Case& c) {
  const Device device = device_um(c);
  return device.empty() || device.depth() <= 0.5 * device.gap();
}

FlowEstimate estimate_flow(const Case& c) {
  const double dx = c.fluid.lattice_spacing_um;
  const LatticeParameters l = to_lattice(c);
  const Mobility& m = device_mobility_um2(c);
  const double force = l.force_density / (l.viscosity * dx * dx);
  const double epsilon = c.geometry.epsilon();
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
