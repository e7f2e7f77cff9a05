#include "fluid/lattice.hpp"

#include <algorithm>
#include <experimental/simd>

#include "fluid/collision.hpp"

namespace dld {

namespace stdx = std::experimental;
using d3q19::directions;
using d3q19::pairs;

template <class Real>
Lattice<Real>::Lattice(const UnitCell& cell, const FluidModel& model)
    : cell_(cell),
      model_(model),
      layout_(cell.nx, cell.ny, cell.nz),
      places_(streaming_places(cell, layout_)),
      links_(build_links(cell, layout_, model.walls, model.wall_motion)) {
  const std::size_t nodes = layout_.field_size();
  uniform_rates_ =
      relaxation_rates(model.collision == CollisionModel::bgk, static_cast<Real>(model.relaxation_time),
                       static_cast<Real>(model.magic_parameter));
  populations_.assign(layout_.populations_size(), Real(0));
  out_of_cache_ = populations_.size() * sizeof(Real) > smallest_to_fetch;
  for (auto& component : force) component.assign(nodes, Real(0));
  for (auto& component : velocity) component.assign(nodes, Real(0));
  relaxation_time.assign(nodes, static_cast<Real>(model.relaxation_time));
  local_step_done_.assign(static_cast<std::size_t>(cell.nx), 0);
  fluid_mask.assign(nodes, Real(0));
  for (int x = 0; x < cell.nx; ++x) {
    const auto first = static_cast<std::uint32_t>(segments_.size());
    for (int z = 0; z < cell.nz; ++z) {
      for (int y = 0; y < cell.ny; ++y) {
        if (cell.is_solid(x, y, z)) continue;
        fluid_mask[layout_.node(x, y, z)] = Real(1);
        ++fluid_nodes_;
        if (y == 0 || cell.is_solid(x, y - 1, z)) segments_.push_back({x, y, z, 0});
        ++segments_.back().length;
      }
    }
    planes_.push_back({first, static_cast<std::uint32_t>(segments_.size())});
  }
  set_threads(1);
}

template <class Real>
template <bool Stokes, bool Local>
void Lattice<Real>::collide_run(const PlacesOfNode& places, const Segment& run, std::ptrdiff_t ahead) {
  using Vector = stdx::native_simd<Real>;
  constexpr int width = static_cast<int>(Vector::size());
  const std::uint32_t start = layout_.node(run.x, run.y, run.z);  // in the fields
  Real* const base = populations_.data() + layout_.population(0, run.x, run.y, run.z);
  const bool bgk = model_.collision == CollisionModel::bgk;
  const Real magic = static_cast<Real>(model_.magic_parameter);
  const Rates<Vector> uniform{Vector(uniform_rates_.even), Vector(uniform_rates_.odd)};
  constexpr int for_reading = 0, into_second_cache = 2;

  const auto advance = [&](int k, auto load, auto store) __attribute__((always_inline)) {
    Real* const node = base + k;
    Vector f[directions];
    if (ahead != 0) {
#pragma GCC unroll 19
      for (std::size_t i = 0; i < directions; ++i)
        __builtin_prefetch(node + ahead + i * layout_.plane, for_reading, into_second_cache);
    }
#pragma GCC unroll 19
    for (std::size_t i = 0; i < directions; ++i) load(f[i], node + places[i]);
    Vector fx = static_cast<Real>(uniform_force_[0]), fy = static_cast<Real>(uniform_force_[1]),
           fz = static_cast<Real>(uniform_force_[2]);
    Rates<Vector> rates = uniform;
    if constexpr (Local) {
      Vector local, tau;
      load(local, force[0].data() + start + k), fx += local;
      load(local, force[1].data() + start + k), fy += local;
      load(local, force[2].data() + start + k), fz += local;
      load(tau, relaxation_time.data() + start + k);
      rates = relaxation_rates(bgk, tau, magic);
    }
    const Moments<Vector> m = collide<Stokes>(f, fx, fy, fz, rates);
    if constexpr (Local) {
      store(m.ux, velocity[0].data() + start + k);
      store(m.uy, velocity[1].data() + start + k);
      store(m.uz, velocity[2].data() + start + k);
    }
    store(f[0], node);
    // Each pair exchanges its two places.
#pragma GCC unroll 9
    for (std::size_t p = 0; p < pairs; ++p) {
      store(f[2 * p + 2], node + places[2 * p + 1]);
      store(f[2 * p + 1], node + places[2 * p + 2]);
    }
  };

  int k = 0;
  for (; k + width <= run.length; k += width) {
    advance(
        k, [](Vector& v, const Real* from) { v.copy_from(from, stdx::element_aligned); },
        [](const Vector& v, Real* to) { v.copy_to(to, stdx::element_aligned); });
  }
  if (k < run.length) {
    const typename Vector::mask_type tail = Vector([](auto lane) {
                                              return static_cast<Real>(static_cast<int>(lane));
                                            }) < static_cast<Real>(run.length - k);
    // The lanes past the end work on whatever stands there and put it back: a masked store costs some
    // processors as much as the collision.
    advance(
        k, [](Vector& v, const Real* from) { v.copy_from(from, stdx::element_aligned); },
        [&](const Vector& v, Real* to) {
          Vector kept(to, stdx::element_aligned);
          where(tail, kept) = v;
          kept.copy_to(to, stdx::element_aligned);
        });
  }
}

template <class Real>
template <bool Stokes>
void Lattice<Real>::collide_plane(Phase phase, int x, const ActiveRange& range, int fetched_plane) {
  const std::ptrdiff_t ahead =
      out_of_cache_ && fetched_plane > x && fetched_plane < cell_.nx
          ? layout_.population(0, fetched_plane, 0, 0) - layout_.population(0, x, 0, 0)
          : 0;
  constexpr int width = static_cast<int>(stdx::native_simd<Real>::size());
  const Row plane = planes_[static_cast<std::size_t>(x)];
  for (std::uint32_t s = plane.first; s < plane.last; ++s) {
    const Segment& segment = segments_[s];
    const PlacesOfNode& places =
        phase == Phase::local ? places_.local : places_.streaming[static_cast<std::size_t>(segment.z)];
    if (range.length == 0) {
      collide_run<Stokes, false>(places, segment, ahead);
      continue;
    }
    // Cut the segment where the active range begins and ends; the range may wrap around once.
    const int first = range.begin, last = range.begin + range.length, end = segment.y + segment.length;
    const std::array<std::array<int, 2>, 2> parts{{{first - cell_.ny, last - cell_.ny}, {first, last}}};
    int y = segment.y;
    for (const auto& part : parts) {
      int from = std::clamp(part[0], y, end), to = std::clamp(part[1], y, end);
      if (from == to) continue;
      // Whole vectors: the nodes that this adds have no force, and the relaxation time of the outside.
      from = y + (from - y) / width * width;
      to = std::min(end, from + (to - from + width - 1) / width * width);
      if (from > y) collide_run<Stokes, false>(places, {x, y, segment.z, from - y}, ahead);
      collide_run<Stokes, true>(places, {x, from, segment.z, to - from}, ahead);
      y = to;
    }
    if (y < end) collide_run<Stokes, false>(places, {x, y, segment.z, end - y}, ahead);
  }
}

template <class Real>
void Lattice<Real>::set_threads(int threads) {
  // The two planes at either end of a block are treated apart.
  const int count = std::clamp(threads, 1, std::max(1, cell_.nx / 4));
  blocks_.assign(1, 0);
  std::size_t nodes = 0;
  for (int x = 0; x < cell_.nx && static_cast<int>(blocks_.size()) < count; ++x) {
    const Row plane = planes_[static_cast<std::size_t>(x)];
    for (std::uint32_t s = plane.first; s < plane.last; ++s)
      nodes += static_cast<std::size_t>(segments_[s].length);
    const int left = count - static_cast<int>(blocks_.size());  // blocks still to come, four planes each
    const bool full = nodes * static_cast<std::size_t>(count) >= fluid_nodes_ * blocks_.size();
    if (x + 1 - blocks_.back() >= 4 && (full || cell_.nx - (x + 1) <= 4 * left)) blocks_.push_back(x + 1);
  }
  blocks_.push_back(cell_.nx);
}

namespace {

/// The active range of plane x; no ranges at all mean that there is no cell.
ActiveRange range_of(const std::vector<ActiveRange>& active, int x) {
  return active.empty() ? ActiveRange{} : active[static_cast<std::size_t>(x)];
}

}  // namespace

template <class Real>
template <bool Stokes>
void Lattice<Real>::local_step(const std::vector<ActiveRange>& active) {
  // Only the planes of the cell, whose velocity is wanted now; the others follow with the streaming step.
  // In chunks, so that a thread finds most planes of its block of the streaming step in its own cache.
#pragma omp parallel for schedule(static) num_threads(threads()) if (threads() > 1)
  for (int x = 0; x < cell_.nx; ++x) {
    const ActiveRange range = range_of(active, x);
    const bool now = range.length > 0;
    local_step_done_[static_cast<std::size_t>(x)] = now ? 1 : 0;
    if (now) collide_plane<Stokes>(Phase::local, x, range, x + 1);
  }
}

template <class Real>
template <bool Stokes>
void Lattice<Real>::finish_local_step(int x) {
  auto& done = local_step_done_[static_cast<std::size_t>(x)];
  if (done == 0) collide_plane<Stokes>(Phase::local, x, {}, no_plane);
  done = 1;
}

// The streaming step of the planes begin .. end - 1 and all links inside; begin and end - 1 are prepared.
template <class Real>
template <bool Stokes>
void Lattice<Real>::sweep(int begin, int end, const std::vector<ActiveRange>& active) {
  for (int x = begin; x < end; ++x) {
    if (x + 2 < end) {
      finish_local_step<Stokes>(x + 2);
      apply(links_.before[static_cast<std::size_t>(x + 1)]);
    }
    // The next plane but two is fetched meanwhile: its local step comes next, and would wait for the memory.
    collide_plane<Stokes>(Phase::streaming, x, range_of(active, x), x + 3);
    if (x >= begin + 2) apply(links_.after[static_cast<std::size_t>(x - 1)]);
  }
}

template <class Real>
template <bool Stokes>
void Lattice<Real>::streaming_step(const std::vector<ActiveRange>& active) {
  // What concerns the planes at both ends of a block is done by all threads before and after the sweeps: a
  // plane may be prepared once both neighbours have had their local step, and be brought home once both have
  // streamed.
  const int count = threads();
  const auto first = [this](int block) { return blocks_[static_cast<std::size_t>(block)]; };
  const auto last = [this](int block) { return blocks_[static_cast<std::size_t>(block) + 1] - 1; };
  const auto apply_at_ends = [&](const std::vector<LinkTable>& tables, int block) {
    apply(tables[static_cast<std::size_t>(first(block))]);
    if (last(block) > first(block)) apply(tables[static_cast<std::size_t>(last(block))]);
  };
#pragma omp parallel num_threads(count) if (count > 1)
  {
#pragma omp for schedule(static, 1)
    for (int b = 0; b < count; ++b) {
      for (const int x : {first(b), first(b) + 1, last(b) - 1, last(b)})
        finish_local_step<Stokes>(std::clamp(x, first(b), last(b)));
    }
#pragma omp for schedule(static, 1)
    for (int b = 0; b < count; ++b) apply_at_ends(links_.before, b);
#pragma omp for schedule(static, 1)
    for (int b = 0; b < count; ++b) sweep<Stokes>(first(b), last(b) + 1, active);
#pragma omp for schedule(static, 1)
    for (int b = 0; b < count; ++b) apply_at_ends(links_.after, b);
  }
}

template <class Real>
void Lattice<Real>::apply(const LinkTable& table) {
  Real* __restrict__ p = populations_.data();
  for (const CopyRun& run : table.runs) {
    Real* __restrict__ to = p + run.destination;
    const Real* __restrict__ from = p + run.source;
    for (std::uint32_t k = 0; k < run.length; ++k) to[k] = from[k];
  }
  const std::size_t row = layout_.row;
  for (const Copy& copy : table.copies) {
    Real* to = p + copy.destination;
    const Real* from = p + copy.source;
    for (std::uint32_t layer = 0; layer < copy.layers; ++layer, to += row, from += row) *to = *from;
  }
  for (const Combination& link : table.combinations) {
    const Real a = static_cast<Real>(link.weight[0]), b = static_cast<Real>(link.weight[1]),
               c = static_cast<Real>(link.weight[2]);
    Real* to = p + link.destination;
    const Real *from_a = p + link.source[0], *from_b = p + link.source[1], *from_c = p + link.source[2];
    for (std::size_t layer = 0, at = 0; layer < link.layers; ++layer, at += row)
      to[at] = a * from_a[at] + b * from_b[at] + c * from_c[at];
  }
  for (const Addition& link : table.additions) p[link.destination] += static_cast<Real>(link.constant);
}

template <class Real>
void Lattice<Real>::step(const std::vector<ActiveRange>& active) {
  const bool stokes = model_.equilibrium == EquilibriumModel::stokes;
  if (even_) {
    stokes ? local_step<true>(active) : local_step<false>(active);
  } else {
    stokes ? streaming_step<true>(active) : streaming_step<false>(active);
  }
  even_ = !even_;
}

template <class Real>
std::size_t Lattice<Real>::memory_bytes() const {
  return (populations_.size() + 8 * layout_.field_size()) * sizeof(Real);
}

template class Lattice<float>;
template class Lattice<double>;

}  // namespace dld
