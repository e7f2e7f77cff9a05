#include "fluid/links.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "fluid/d3q19.hpp"

namespace dld {
namespace {

using d3q19::c;
using d3q19::mirrored;
using d3q19::opposite;

d3q19::Velocity velocity(int i) {
  return c[static_cast<std::size_t>(i)];
}

/// Central linear walls closer to a node count as this far away, in link lengths: nodes on the wall make
/// flows with jumps of the relaxation time beside it (a membrane near a pillar) unstable. 0.05 is enough; at
/// dx = 0.4 um the separation streamline moves by 0.002 um.
constexpr double nearest_cut = 0.1;

/// A population f_i at a fluid node, addressed in the two states of the in-place scheme.
struct Population {
  std::uint32_t after_local;      ///< where the local step left the post-collision f*_i of the node
  std::uint32_t after_streaming;  ///< where the streaming step wrote the post-collision f*_i of the node
};

class LinkBuilder {
 public:
  LinkBuilder(const UnitCell& cell, const LatticeLayout& layout, WallModel model, const WallMotion& motion)
      : cell_(cell),
        layout_(layout),
        places_(streaming_places(cell, layout)),
        model_(model),
        motion_(motion) {}

  LinkTables build() {
    LinkTables tables;
    for (int x = 0; x < cell_.nx; ++x) {
      before_ = {};
      after_ = {};
      for (int z = 0; z < cell_.nz; ++z) {
        for (int y = 0; y < cell_.ny; ++y) {
          if (cell_.is_solid(x, y, z)) continue;
          for (int i = 1; i < d3q19::directions; ++i) add_link(x, y, z, i);
        }
      }
      tables.before.push_back(finish(before_));
      tables.after.push_back(finish(after_));
    }
    return tables;
  }

 private:
  /// Where the streaming step of a node finds f_i and leaves f*_-i.
  std::uint32_t streaming_place(int i, int x, int y, int z) const {
    const std::ptrdiff_t offset = places_.streaming[static_cast<std::size_t>(z)][static_cast<std::size_t>(i)];
    return static_cast<std::uint32_t>(layout_.population(0, x, y, z) + offset);
  }

  Population population(int i, int x, int y, int z) const {
    return {layout_.population(opposite(i), x, y, z), streaming_place(opposite(i), x, y, z)};
  }

  /// Post-collision population i of raw node (x, y, z), which may be an image of the fluid node behind it.
  Population image_population(int i, int x, int y, int z) const {
    const NodeImage image = cell_.wrap(x, y, z);
    return population(image.mirrored ? mirrored(i) : i, image.x, image.y, image.z);
  }

  bool fluid(int x, int y, int z) const {
    if (cell_.side(z) != HeightSide::inside) return false;
    const NodeImage image = cell_.wrap(x, y, z);
    return !cell_.is_solid(image.x, image.y, image.z);
  }

  /// Where f_i of the node is expected: read by the streaming step (before), read by the local step (after).
  Population destination(int i, int x, int y, int z) const {
    return {streaming_place(i, x, y, z), layout_.population(i, x, y, z)};
  }

  /// The incoming population i of fluid node (x, y, z), if it does not stream from a fluid node in the box or
  /// from a wall at rest.
  void add_link(int x, int y, int z, int i) {
    const auto v = velocity(i);
    const int sx = x - v.x, sy = y - v.y, sz = z - v.z;
    const Population to = destination(i, x, y, z);
    const HeightSide side = cell_.side(sz);
    if (side != HeightSide::inside) {
      // Half-way wall; a wall moving with U adds 6 w_i rho0 (c_i . U) (Ladd 1994) to what has come back.
      const double speed = side == HeightSide::above_wall ? motion_.above : motion_.below;
      if (speed * v.x != 0.0) add(to, 6.0 * d3q19::weight(i) * v.x * speed);
      return;
    }
    if (fluid(sx, sy, sz)) {
      const bool in_box = sx >= 0 && sx < cell_.nx && sy >= 0 && sy < cell_.ny;
      if (!in_box) copy(to, image_population(i, sx, sy, sz));
      return;
    }
    const int out = opposite(i);
    if (model_ != WallModel::half_way && add_interpolated(to, x, y, z, i)) return;
    copy(to, population(out, x, y, z));
  }

  /// Interpolated bounce-back of either model. Returns false where the second node on the link is needed and
  /// not fluid: the caller then falls back to the half-way wall.
  bool add_interpolated(const Population& to, int x, int y, int z, int i) {
    const int out = opposite(i);
    const auto v = velocity(out);
    const double q = cell_.wall_fraction(x, y, z, v.x, v.y, v.z);
    const bool looks_behind = model_ == WallModel::central_linear || q < 0.5;
    if (looks_behind && !fluid(x - v.x, y - v.y, z - v.z)) return false;
    const Population here = population(out, x, y, z), back = population(i, x, y, z);
    const Population second = looks_behind ? image_population(out, x - v.x, y - v.y, z - v.z) : back;
    combine(to, {here, second, back}, interpolation_weights(q));
    return true;
  }

  /// Weights of f*_out, of the same at the node behind (interpolated, q >= 1/2: of f*_i) and of f*_i; q is
  /// the distance of the wall in link lengths.
  std::array<double, 3> interpolation_weights(double q) const {
    if (model_ == WallModel::central_linear) {
      const double cut = std::max(q, nearest_cut), share = (1.0 - 2.0 * cut) / (1.0 + 2.0 * cut);
      return {1.0, share, -share};
    }
    if (q < 0.5) return {2.0 * q, 1.0 - 2.0 * q, 0.0};
    return {0.5 / q, 1.0 - 0.5 / q, 0.0};
  }

  void copy(const Population& to, const Population& from) {
    before_.copies.push_back({to.after_local, from.after_local, 1});
    after_.copies.push_back({to.after_streaming, from.after_streaming, 1});
  }

  void add(const Population& to, double constant) {
    before_.additions.push_back({to.after_local, constant});
    after_.additions.push_back({to.after_streaming, constant});
  }

  void combine(const Population& to, const std::array<Population, 3>& from,
               const std::array<double, 3>& weight) {
    before_.combinations.push_back(
        {to.after_local, {from[0].after_local, from[1].after_local, from[2].after_local}, weight, 1});
    after_.combinations.push_back(
        {to.after_streaming,
         {from[0].after_streaming, from[1].after_streaming, from[2].after_streaming},
         weight,
         1});
  }

  /// Links of one plane as they are found.
  struct Found {
    std::vector<CopyRun> copies;
    std::vector<Combination> combinations;
    std::vector<Addition> additions;
  };

  /// Links, sorted by destination, with equal ones above one another joined; `continues(link, above, shift)`
  /// tells whether `above` is the same link, `shift` places further.
  template <class Link, class Function>
  std::vector<Link> in_columns(const std::vector<Link>& single, Function&& continues) const {
    std::unordered_map<std::uint32_t, std::size_t> at;
    for (std::size_t n = 0; n < single.size(); ++n) at[single[n].destination] = n;
    std::vector<bool> joined(single.size(), false);
    std::vector<Link> columns;
    for (std::size_t n = 0; n < single.size(); ++n) {
      if (joined[n]) continue;
      Link column = single[n];
      for (std::uint32_t shift = layout_.row;; ++column.layers, shift += layout_.row) {
        const auto above = at.find(column.destination + shift);
        if (above == at.end() || !continues(column, single[above->second], shift)) break;
        joined[above->second] = true;
      }
      columns.push_back(column);
    }
    return columns;
  }

  /// Sorts by destination and merges neighbours into runs, so that rows move as blocks.
  LinkTable finish(Found& found) const {
    std::sort(found.copies.begin(), found.copies.end(),
              [](const CopyRun& a, const CopyRun& b) { return a.destination < b.destination; });
    std::sort(found.combinations.begin(), found.combinations.end(),
              [](const Combination& a, const Combination& b) { return a.destination < b.destination; });
    std::vector<CopyRun> runs;
    for (const CopyRun& next : found.copies) {
      const bool continues = !runs.empty() &&
                             next.destination == runs.back().destination + runs.back().length &&
                             next.source == runs.back().source + runs.back().length;
      if (continues) {
        ++runs.back().length;
      } else {
        runs.push_back(next);
      }
    }
    LinkTable table;
    std::vector<Copy> copies;
    for (const CopyRun& run : runs) {
      constexpr std::uint32_t worth_a_loop = 8;
      if (run.length >= worth_a_loop) {
        table.runs.push_back(run);
        continue;
      }
      for (std::uint32_t k = 0; k < run.length; ++k) copies.push_back({run.destination + k, run.source + k});
    }
    table.copies = in_columns(copies, [](const Copy& link, const Copy& above, std::uint32_t shift) {
      return above.source == link.source + shift;
    });
    table.combinations = in_columns(
        found.combinations, [](const Combination& link, const Combination& above, std::uint32_t shift) {
          return above.weight == link.weight && above.source[0] == link.source[0] + shift &&
                 above.source[1] == link.source[1] + shift && above.source[2] == link.source[2] + shift;
        });
    table.additions = std::move(found.additions);
    return table;
  }

  const UnitCell& cell_;
  const LatticeLayout& layout_;
  StreamingPlaces places_;
  WallModel model_;
  WallMotion motion_;
  Found before_, after_;
};

std::uint32_t round_up(std::uint32_t n, std::uint32_t multiple) {
  return (n + multiple - 1) / multiple * multiple;
}

}  // namespace

LatticeLayout::LatticeLayout(int nx_, int ny_, int nz_) : nx(nx_), ny(ny_), nz(nz_) {
  // 16 extra places per row hold both ghosts: y = ny behind the row, y = -1 at the end of the row before.
  row = round_up(static_cast<std::uint32_t>(ny), 16u) + 16u;
  plane = row * static_cast<std::uint32_t>(nz);
  // An odd number of cache lines between directions keeps them out of each other's cache sets.
  if ((plane / 16u) % 2u == 0u) plane += 16u;
}

StreamingPlaces streaming_places(const UnitCell& cell, const LatticeLayout& layout) {
  const auto plane = static_cast<std::ptrdiff_t>(layout.plane), row = static_cast<std::ptrdiff_t>(layout.row);
  StreamingPlaces places;
  for (int i = 0; i < d3q19::directions; ++i) places.local[static_cast<std::size_t>(i)] = i * plane;
  for (int z = 0; z < cell.nz; ++z) {
    PlacesOfNode& at = places.streaming.emplace_back(places.local);
    for (int i = 1; i < d3q19::directions; ++i) {
      const auto v = velocity(i);
      if (cell.side(z - v.z) != HeightSide::inside) continue;  // bounce-back: the node's own place i
      const NodeImage image = cell.wrap(0, 0, z - v.z);
      const int arriving = image.mirrored ? mirrored(i) : i;
      at[static_cast<std::size_t>(i)] = opposite(arriving) * plane + (image.z - z) * row - v.y -
                                        static_cast<std::ptrdiff_t>(v.x) * d3q19::directions * plane;
    }
  }
  return places;
}

LinkTables build_links(const UnitCell& cell, const LatticeLayout& layout, WallModel model,
                       const WallMotion& motion) {
  return LinkBuilder(cell, layout, model, motion).build();
}

}  // namespace dld
