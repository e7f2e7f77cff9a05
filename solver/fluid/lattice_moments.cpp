/// Density and velocity of the fluid at rest between two steps: at a node, over all nodes, and the mean held.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "fluid/lattice.hpp"

namespace dld {

using d3q19::directions;

template <class Real>
std::array<double, 4> Lattice<Real>::moments(int x, int y, int z) const {
  assert(even_);
  const std::uint32_t here = layout_.node(x, y, z);
  const Real* const f0 = populations_.data() + layout_.population(0, x, y, z);
  double deviation = 0;
  std::array<double, 3> j{};
  for (int i = 0; i < directions; ++i) {
    const double f = static_cast<double>(f0[static_cast<std::size_t>(i) * layout_.plane]);
    const auto v = d3q19::c[static_cast<std::size_t>(i)];
    deviation += f;
    j[0] += v.x * f;
    j[1] += v.y * f;
    j[2] += v.z * f;
  }
  const double rho = model_.equilibrium == EquilibriumModel::stokes ? 1.0 : 1.0 + deviation;
  for (std::size_t k = 0; k < 3; ++k) {
    j[k] = (j[k] + 0.5 * (uniform_force_[k] + static_cast<double>(force[k][here]))) / rho;
  }
  return {deviation, j[0], j[1], j[2]};
}

template <class Real>
FlowStatistics Lattice<Real>::statistics() const {
  FlowStatistics s;
  s.min_density_deviation = 1e300;
  s.max_density_deviation = -1e300;
  // By blocks of nodes, whose moments come in vectors; every sum runs over the nodes in their order.
  constexpr int block = 64;
  std::array<double, block> deviation, inverse, speed2;
  std::array<std::array<double, block>, 3> u;
  const auto add_block = [&](const Segment& segment, int first, int length) {
    const std::size_t n = static_cast<std::size_t>(length);
    const std::uint32_t start = layout_.node(segment.x, segment.y + first, segment.z);
    const Real* const f0 =
        populations_.data() + layout_.population(0, segment.x, segment.y + first, segment.z);
    std::fill_n(deviation.begin(), n, 0.0);
    for (auto& component : u) std::fill_n(component.begin(), n, 0.0);
    for (int i = 0; i < directions; ++i) {
      const Real* const f = f0 + static_cast<std::size_t>(i) * layout_.plane;
      const auto v = d3q19::c[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < n; ++k) {
        const double value = static_cast<double>(f[k]);
        deviation[k] += value;
        u[0][k] += v.x * value;
        u[1][k] += v.y * value;
        u[2][k] += v.z * value;
      }
    }
    for (std::size_t k = 0; k < n; ++k)
      inverse[k] = model_.equilibrium == EquilibriumModel::stokes ? 1.0 : 1.0 / (1.0 + deviation[k]);
    for (std::size_t d = 0; d < 3; ++d) {
      const Real* const local = force[d].data() + start;
      for (std::size_t k = 0; k < n; ++k)
        u[d][k] = (u[d][k] + 0.5 * (uniform_force_[d] + static_cast<double>(local[k]))) * inverse[k];
    }
    for (std::size_t k = 0; k < n; ++k) speed2[k] = u[0][k] * u[0][k] + u[1][k] * u[1][k] + u[2][k] * u[2][k];
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t d = 0; d < 3; ++d) s.velocity[d] += u[d][k];
      s.mean_density_deviation += deviation[k];
      s.min_density_deviation = std::min(s.min_density_deviation, deviation[k]);
      s.max_density_deviation = std::max(s.max_density_deviation, deviation[k]);
      // NaN is taken and then kept: a diverged flow must show.
      if (speed2[k] > s.max_speed || std::isnan(speed2[k])) s.max_speed = speed2[k];
    }
  };
  for (const Segment& segment : segments_) {
    for (int first = 0; first < segment.length; first += block)
      add_block(segment, first, std::min(block, segment.length - first));
  }
  const double n = static_cast<double>(fluid_nodes_);
  for (double& u_mean : s.velocity) u_mean /= n;
  s.mean_density_deviation /= n;
  s.max_speed = std::sqrt(s.max_speed);
  return s;
}

template <class Real>
void Lattice<Real>::shift_density(double deviation) {
  assert(even_);
  for (int i = 0; i < directions; ++i) {
    const Real add = static_cast<Real>(d3q19::weight(i) * deviation);
    for (const Segment& segment : segments_) {
      Real* f = populations_.data() + layout_.population(i, segment.x, segment.y, segment.z);
      for (int k = 0; k < segment.length; ++k) f[k] += add;
    }
  }
}

template std::array<double, 4> Lattice<float>::moments(int, int, int) const;
template std::array<double, 4> Lattice<double>::moments(int, int, int) const;
template FlowStatistics Lattice<float>::statistics() const;
template FlowStatistics Lattice<double>::statistics() const;
template void Lattice<float>::shift_density(double);
template void Lattice<double>::shift_density(double);

}  // namespace dld
