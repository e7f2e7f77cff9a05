#include "coupling/immersed_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <experimental/simd>
#include <utility>

namespace dld {
namespace {

namespace stdx = std::experimental;

constexpr int padding = 4;  ///< places behind a row that continue it periodically

int floor_div(int a, int n) {
  return a >= 0 ? a / n : -((-a + n - 1) / n);
}

int kernel_width(Kernel kernel) {
  return kernel == Kernel::phi2 ? Phi2::width : kernel == Kernel::phi3 ? Phi3::width : Phi4::width;
}

}  // namespace

template <class Real>
ImmersedBoundary<Real>::ImmersedBoundary(Lattice<Real>& lattice, Kernel kernel,
                                         std::vector<CoupledNode> nodes)
    : lattice_(lattice),
      kernel_(kernel),
      nodes_(std::move(nodes)),
      stencils_(nodes_.size()),
      active_(static_cast<std::size_t>(lattice.cell().nx)),
      width_(kernel_width(kernel)) {
  const LatticeLayout& layout = lattice.layout();
  const UnitCell& cell = lattice.cell();
  for (int raw = -layer_margin; raw < cell.nz + layer_margin; ++raw) {
    Layer at{0, 1.0, 0.0};
    if (cell.side(raw) == HeightSide::inside) {
      const NodeImage image = cell.wrap(0, 0, raw);
      // A mirror image far below the plane would lie beyond the other wall.
      if (image.z < cell.nz)
        at = {static_cast<std::uint32_t>(image.z) * layout.row, image.mirrored ? -1.0 : 1.0, 1.0};
    }
    layers_.push_back(at);
  }
  for (int x = 0; x < layout.nx; ++x) {
    for (int z = 0; z < layout.nz; ++z) {
      for (int y = 0; y < padding; ++y) {
        lattice.fluid_mask[layout.node(x, layout.ny + y, z)] = lattice.fluid_mask[layout.node(x, y, z)];
      }
    }
  }
}

template <class Real>
template <class Phi>
typename ImmersedBoundary<Real>::Stencil ImmersedBoundary<Real>::stencil(double x, double y, double z,
                                                                         bool near_solid) const {
  const UnitCell& cell = lattice_.cell();
  const LatticeLayout& layout = lattice_.layout();
  Stencil s{};
  std::array<double, 4> w{};
  const auto take = [&w](std::array<Real, 4>& to) {
    for (std::size_t k = 0; k < 4; ++k) to[k] = static_cast<Real>(w[k]);
  };
  Phi::weights(x, w.data());
  take(s.wx);
  Phi::weights(y, w.data());
  take(s.wy);
  Phi::weights(z, w.data());

  const int x0 = Phi::first(x), y0 = Phi::first(y), z0 = Phi::first(z);
  for (int i = 0; i < 4; ++i) {
    const int raw = x0 + std::min(i, Phi::width - 1);
    const int n = floor_div(raw, cell.nx);
    const int y_shifted = y0 - n * cell.row_shift;
    s.plane[static_cast<std::size_t>(i)] =
        layout.node(raw - n * cell.nx, y_shifted - floor_div(y_shifted, cell.ny) * cell.ny, 0);
  }
  double inside = 0.0;  // sum of the weights between the walls
  for (int k = 0; k < 4; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const int raw = std::clamp(z0 + std::min(k, Phi::width - 1), -layer_margin, cell.nz + layer_margin - 1);
    const Layer& at = layer(raw);
    w[index] *= at.inside;  // beyond a wall: u = 0 there, no force is spread
    s.sign[index] = static_cast<Real>(at.sign);
    s.layer[index] = at.offset;
    inside += w[index];
  }
  take(s.wz);
  s.scale = inside > 1e-6 ? static_cast<Real>(1.0 / inside) : Real(0);
  s.masked = near_solid;
  if (near_solid) {
    double fluid = 0.0;
    for (std::size_t i = 0; i < Phi::width; ++i) {
      for (std::size_t k = 0; k < Phi::width; ++k) {
        for (std::size_t j = 0; j < Phi::width; ++j) {
          fluid += static_cast<double>(s.wx[i]) * static_cast<double>(s.wz[k]) *
                   static_cast<double>(s.wy[j]) *
                   static_cast<double>(lattice_.fluid_mask[s.plane[i] + s.layer[k] + j]);
        }
      }
    }
    s.scale = fluid > 1e-6 ? static_cast<Real>(1.0 / fluid) : Real(0);
  }
  return s;
}

template <class Real>
template <class Phi>
void ImmersedBoundary<Real>::locate_with(const Eigen::MatrixX3d& x,
                                         const std::vector<std::uint8_t>& near_solid) {
  const UnitCell& cell = lattice_.cell();
#pragma omp parallel for num_threads(lattice_.threads()) if (shared())
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const int v = nodes_[n].vertex;
    stencils_[n] = stencil<Phi>(x(v, 0) - cell.origin_x, x(v, 1) - cell.origin_y, x(v, 2) - cell.origin_z,
                                near_solid[static_cast<std::size_t>(v)] != 0);
  }
}

template <class Real>
void ImmersedBoundary<Real>::locate(const Eigen::MatrixX3d& x, const std::vector<std::uint8_t>& near_solid) {
  switch (kernel_) {
    case Kernel::phi2:
      locate_with<Phi2>(x, near_solid);
      break;
    case Kernel::phi3:
      locate_with<Phi3>(x, near_solid);
      break;
    case Kernel::phi4:
      locate_with<Phi4>(x, near_solid);
      break;
  }
  mark_active(x);
}

template <class Real>
void ImmersedBoundary<Real>::mark_active(const Eigen::MatrixX3d& x) {
  const UnitCell& cell = lattice_.cell();
  constexpr int reach = 2;  // of the widest kernel, and of the viscosity of an inside that is a little old
  const auto range = [&](int axis, double origin) {
    return std::pair{static_cast<int>(std::floor(x.col(axis).minCoeff() - origin)) - reach,
                     static_cast<int>(std::floor(x.col(axis).maxCoeff() - origin)) + reach};
  };
  const auto [x_first, x_last] = range(0, cell.origin_x);
  const auto [y_first, y_last] = range(1, cell.origin_y);
  const int length = y_last - y_first + 1;
  const bool everywhere = x_last - x_first + 1 >= cell.nx || length >= cell.ny;
  std::fill(active_.begin(), active_.end(), everywhere ? ActiveRange{0, cell.ny} : ActiveRange{});
  if (everywhere) return;
  for (int raw = x_first; raw <= x_last; ++raw) {
    const int n = floor_div(raw, cell.nx);
    const int y = y_first - n * cell.row_shift;
    active_[static_cast<std::size_t>(raw - n * cell.nx)] = {y - floor_div(y, cell.ny) * cell.ny, length};
  }
}

template <class Real>
void ImmersedBoundary<Real>::spread(const Eigen::MatrixX3d& f) {
  using Four = stdx::fixed_size_simd<Real, 4>;
  const auto width = static_cast<std::size_t>(width_);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Stencil& s = stencils_[n];
    const CoupledNode& node = nodes_[n];
    // A node on the mirror plane is its own image: half of its force belongs to the upper half.
    const double share = node.mirror_vertex == node.vertex ? 0.5 : 1.0;
    const Real fx = static_cast<Real>(share * f(node.vertex, 0)) * s.scale;
    const Real fy = static_cast<Real>(share * f(node.vertex, 1)) * s.scale;
    const Real fz = static_cast<Real>(share * f(node.vertex, 2)) * s.scale;
    const Four wy(s.wy.data(), stdx::element_aligned);
    for (std::size_t i = 0; i < width; ++i) {
      for (std::size_t k = 0; k < width; ++k) {
        const std::uint32_t at = s.plane[i] + s.layer[k];
        Four w = (s.wx[i] * s.wz[k]) * wy;
        if (s.masked) w *= Four(lattice_.fluid_mask.data() + at, stdx::element_aligned);
        const auto add = [&](LatticeArray<Real>& component, Real value) {
          Real* const place = component.data() + at;
          Four sum(place, stdx::element_aligned);
          sum += value * w;
          sum.copy_to(place, stdx::element_aligned);
        };
        add(lattice_.force[0], fx);
        add(lattice_.force[1], fy);
        add(lattice_.force[2], fz * s.sign[k]);
      }
    }
  }
  fold_force();
}

template <class Real>
void ImmersedBoundary<Real>::interpolate(Eigen::MatrixX3d& v) {
  extend(lattice_.velocity);
  gather(lattice_.velocity, v);
}

template <class Real>
void ImmersedBoundary<Real>::interpolate_force(Eigen::MatrixX3d& f) {
  extend(lattice_.force);
  gather(lattice_.force, f);
  for_wrapped_rows([this](std::uint32_t behind, std::uint32_t) {  // spread() adds to the padding
    for (auto& component : lattice_.force) std::fill_n(&component[behind], padding, Real(0));
  });
}

template <class Real>
void ImmersedBoundary<Real>::gather(const Field& field, Eigen::MatrixX3d& v) const {
  using Four = stdx::fixed_size_simd<Real, 4>;
  const auto width = static_cast<std::size_t>(width_);
#pragma omp parallel for num_threads(lattice_.threads()) if (shared())
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Stencil& s = stencils_[n];
    Four ux = Real(0), uy = Real(0), uz = Real(0);
    for (std::size_t i = 0; i < width; ++i) {
      for (std::size_t k = 0; k < width; ++k) {
        const std::uint32_t at = s.plane[i] + s.layer[k];
        const Real w = s.wx[i] * s.wz[k];
        ux += w * Four(field[0].data() + at, stdx::element_aligned);
        uy += w * Four(field[1].data() + at, stdx::element_aligned);
        uz += (w * s.sign[k]) * Four(field[2].data() + at, stdx::element_aligned);
      }
    }
    const Four wy(s.wy.data(), stdx::element_aligned);
    const CoupledNode& node = nodes_[n];
    const bool on_plane = node.mirror_vertex == node.vertex;
    const double vx = static_cast<double>(stdx::reduce(ux * wy)),
                 vy = static_cast<double>(stdx::reduce(uy * wy));
    const double vz = on_plane ? 0.0 : static_cast<double>(stdx::reduce(uz * wy));
    v.row(node.vertex) << vx, vy, vz;
    if (node.mirror_vertex >= 0 && !on_plane) v.row(node.mirror_vertex) << vx, vy, -vz;
  }
}

template <class Real>
template <class Function>
void ImmersedBoundary<Real>::for_wrapped_rows(Function&& row) {
  const LatticeLayout& layout = lattice_.layout();
  for (int x = 0; x < layout.nx; ++x) {
    const ActiveRange range = active_[static_cast<std::size_t>(x)];
    if (range.begin + range.length <= layout.ny && range.length < layout.ny) continue;
    for (int z = 0; z < layout.nz; ++z) row(layout.node(x, layout.ny, z), layout.node(x, 0, z));
  }
}

template <class Real>
void ImmersedBoundary<Real>::fold_force() {
  for_wrapped_rows([this](std::uint32_t behind, std::uint32_t front) {
    for (auto& component : lattice_.force) {
      for (std::uint32_t y = 0; y < padding; ++y) {
        component[front + y] += component[behind + y];
        component[behind + y] = Real(0);
      }
    }
  });
}

template <class Real>
void ImmersedBoundary<Real>::extend(Field& field) {
  for_wrapped_rows([&field](std::uint32_t behind, std::uint32_t front) {
    for (auto& component : field) {
      for (std::uint32_t y = 0; y < padding; ++y) component[behind + y] = component[front + y];
    }
  });
}

template <class Real>
void ImmersedBoundary<Real>::clear_force() {
  const LatticeLayout& layout = lattice_.layout();
  for (int x = 0; x < layout.nx; ++x) {
    const ActiveRange range = active_[static_cast<std::size_t>(x)];
    if (range.length == 0) continue;
    const int first = range.begin, end = std::min(range.begin + range.length, layout.ny);
    const int wrapped = range.begin + range.length - end;
    for (auto& component : lattice_.force) {
      for (int z = 0; z < layout.nz; ++z) {
        Real* const row = component.data() + layout.node(x, 0, z);
        std::fill(row + first, row + end, Real(0));
        std::fill(row, row + wrapped, Real(0));
      }
    }
  }
}

template class ImmersedBoundary<float>;
template class ImmersedBoundary<double>;

}  // namespace dld
