/// The tables of everything that streaming finds outside the fluid.
#include "fluid/links.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "fluid/d3q19.hpp"
#include "support/fluid_box.hpp"

namespace dld {
namespace {

using test::BoxSize;
using test::unit_cell;

/// The tables of all planes in one, each copy and combination with one layer only.
LinkTable joined(const std::vector<LinkTable>& planes, const LatticeLayout& layout) {
  LinkTable all;
  for (const LinkTable& table : planes) {
    all.runs.insert(all.runs.end(), table.runs.begin(), table.runs.end());
    for (const Copy& c : table.copies) {
      for (std::uint32_t shift = 0; shift < c.layers * layout.row; shift += layout.row)
        all.copies.push_back({c.destination + shift, c.source + shift, 1});
    }
    for (const Combination& c : table.combinations) {
      for (std::uint32_t shift = 0; shift < c.layers * layout.row; shift += layout.row)
        all.combinations.push_back({c.destination + shift,
                                    {c.source[0] + shift, c.source[1] + shift, c.source[2] + shift},
                                    c.weight,
                                    1});
    }
    all.additions.insert(all.additions.end(), table.additions.begin(), table.additions.end());
  }
  return all;
}

/// Destination of every copy or combination, with the number of times it is written.
std::map<std::uint32_t, int> destinations(const LinkTable& table) {
  std::map<std::uint32_t, int> written;
  for (const CopyRun& run : table.runs)
    for (std::uint32_t k = 0; k < run.length; ++k) ++written[run.destination + k];
  for (const Copy& copy : table.copies) ++written[copy.destination];
  for (const Combination& c : table.combinations) ++written[c.destination];
  return written;
}

std::set<std::uint32_t> sources(const LinkTable& table) {
  std::set<std::uint32_t> read;
  for (const CopyRun& run : table.runs)
    for (std::uint32_t k = 0; k < run.length; ++k) read.insert(run.source + k);
  for (const Copy& copy : table.copies) read.insert(copy.source);
  for (const Combination& c : table.combinations) read.insert(c.source.begin(), c.source.end());
  return read;
}

/// Links of fluid nodes that the tables have to serve: the other end is beyond the box in x or y, or in a
/// pillar. Walls at rest, the mirror plane and periodic layers are places of the kernel.
std::size_t links_that_leave(const UnitCell& cell) {
  std::size_t count = 0;
  test::for_fluid_nodes(cell, [&](int x, int y, int z) {
    for (int i = 1; i < d3q19::directions; ++i) {
      const auto c = d3q19::c[static_cast<std::size_t>(i)];
      const int a = x + c.x, b = y + c.y, d = z + c.z;
      if (cell.side(d) != HeightSide::inside) continue;
      const NodeImage image = cell.wrap(a, b, d);
      const bool in_box = a >= 0 && a < cell.nx && b >= 0 && b < cell.ny;
      if (!in_box || cell.is_solid(image.x, image.y, image.z)) ++count;
    }
  });
  return count;
}

const std::vector<BoxSize>& boxes() {
  static const std::vector<BoxSize> all{{12, 13, 4, 3.7, 5, HeightBoundary::walls},
                                        {12, 13, 4, 3.7, 5, HeightBoundary::mirror_and_wall},
                                        {12, 13, 4, 3.7, 0, HeightBoundary::periodic},
                                        {12, 13, 1, 3.7, 7, HeightBoundary::periodic},
                                        {2, 2, 6, 0, 0, HeightBoundary::walls}};
  return all;
}

TEST(Links, EveryLinkThatLeavesTheFluidIsServedOnce) {
  for (const BoxSize& size : boxes()) {
    const UnitCell cell = unit_cell(size);
    const LatticeLayout layout(cell.nx, cell.ny, cell.nz);
    for (auto model : {WallModel::half_way, WallModel::interpolated, WallModel::central_linear}) {
      const LinkTables tables = build_links(cell, layout, model, {});
      for (const LinkTable& table : {joined(tables.before, layout), joined(tables.after, layout)}) {
        const auto written = destinations(table);
        EXPECT_EQ(written.size(), links_that_leave(cell));
        for (const auto& [destination, times] : written) EXPECT_EQ(times, 1);
        // In place: no slot may be both written and read, or the order of the table would matter.
        for (const std::uint32_t source : sources(table)) EXPECT_EQ(written.count(source), 0u);
      }
    }
  }
}

TEST(Links, CombinationsHaveUnitSum) {
  const UnitCell cell = unit_cell(boxes()[0]);
  const LatticeLayout layout(cell.nx, cell.ny, cell.nz);
  for (auto model : {WallModel::interpolated, WallModel::central_linear}) {
    const LinkTables tables = build_links(cell, layout, model, {});
    const LinkTable before = joined(tables.before, layout);
    EXPECT_GT(before.combinations.size(), 100u);
    EXPECT_EQ(before.combinations.size(), joined(tables.after, layout).combinations.size());
    for (const Combination& c : before.combinations) {
      EXPECT_NEAR(c.weight[0] + c.weight[1] + c.weight[2], 1.0, 1e-14);
      EXPECT_GT(c.weight[0], 0.0);
      EXPECT_LE(c.weight[0], 1.0 + 1e-14);
    }
  }
  const LinkTables half_way = build_links(cell, layout, WallModel::half_way, {});
  EXPECT_TRUE(joined(half_way.before, layout).combinations.empty());
}

TEST(Links, APillarIsCutAlikeInAllLayers) {
  const UnitCell cell = unit_cell({24, 25, 8, 7.3, 5, HeightBoundary::walls});
  const LatticeLayout layout(cell.nx, cell.ny, cell.nz);
  const LinkTables tables = build_links(cell, layout, WallModel::interpolated, {});
  std::size_t columns = 0;
  for (const LinkTable& table : tables.before) columns += table.combinations.size();
  EXPECT_LT(columns * 6, joined(tables.before, layout).combinations.size());
}

TEST(Links, MovingWallsAddMomentumAndNoMass) {
  const UnitCell cell = unit_cell(boxes()[4]);
  const LatticeLayout layout(2, 2, 6);
  const LinkTables tables = build_links(cell, layout, WallModel::half_way, {-0.01, 0.03});
  double sum = 0, largest = 0;
  for (const Addition& link : joined(tables.before, layout).additions) {
    sum += link.constant;
    largest = std::max(largest, link.constant);
  }
  EXPECT_NEAR(sum, 0, 1e-16);
  // 6 w (c . U) with w = 1/36 on the diagonals.
  EXPECT_NEAR(largest, 0.03 / 6, 1e-16);
}

/// Every place that a node reads in the streaming step belongs to that node alone: steps may run in any
/// order.
TEST(Links, StreamingPlacesAreSharedByNoTwoNodes) {
  for (const BoxSize& size : boxes()) {
    const UnitCell cell = unit_cell(size);
    const LatticeLayout layout(cell.nx, cell.ny, cell.nz);
    const StreamingPlaces places = streaming_places(cell, layout);
    std::set<std::ptrdiff_t> seen;
    std::size_t count = 0;
    test::for_fluid_nodes(cell, [&](int x, int y, int z) {
      for (const std::ptrdiff_t offset : places.streaming[static_cast<std::size_t>(z)]) {
        seen.insert(layout.population(0, x, y, z) + offset);
        ++count;
      }
    });
    EXPECT_EQ(seen.size(), count);
  }
}

TEST(Links, LayoutKeepsNodesGhostsAndDirectionsApart) {
  const LatticeLayout layout(5, 17, 3);
  std::set<std::uint32_t> slots;
  for (int i = 0; i < d3q19::directions; ++i)
    for (int x = -1; x <= 5; ++x)
      for (int y = -1; y <= 17; ++y)
        for (int z = 0; z < 3; ++z) slots.insert(layout.population(i, x, y, z));
  EXPECT_EQ(slots.size(), static_cast<std::size_t>(19 * 7 * 19 * 3));
  EXPECT_LT(*slots.rbegin(), layout.populations_size());
  EXPECT_EQ(layout.node(2, 0, 1) % 16, 0u);
  EXPECT_EQ(layout.population(3, 2, 0, 1) % 16, 0u);
  EXPECT_LT(layout.node(5, 17, 2), layout.field_size());
}

}  // namespace
}  // namespace dld
