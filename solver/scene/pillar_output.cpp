#include "scene/pillar_output.hpp"

#include <cmath>

#include "geometry/pillar_surface.hpp"

namespace dld {

PillarPlaces pillars_along(const PillarArray& pillars, const std::vector<double>& x,
                           const std::vector<double>& y) {
  PillarPlaces places;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double before = std::floor(x[i] / pillars.pitch_x());
    for (const double column : {before, before + 1}) {
      const double lane = std::floor((y[i] - column * pillars.row_shift()) / pillars.pitch_y());
      for (const double m : {lane, lane + 1}) places.emplace(std::lround(column), std::lround(m));
    }
  }
  return places;
}

void write_pillars(RunContext& context, const PillarArray& pillars, const PillarPlaces& places,
                   double half_height, double um_per_lu) {
  const Surface wall = pillar_wall(pillars.shape(), half_height);
  if (wall.vertices.rows() == 0 || places.empty()) return;
  const Eigen::Index nv = wall.vertices.rows(), nf = wall.triangles.rows();
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixX2d centres(count, 2);
  Eigen::MatrixX3d points(count * nv, 3);
  Eigen::MatrixX3i triangles(count * nf, 3);
  Eigen::Index k = 0;
  for (const auto& [n, m] : places) {
    const double row = static_cast<double>(n), lane = static_cast<double>(m);
    centres.row(k) << row * pillars.pitch_x(), lane * pillars.pitch_y() + row * pillars.row_shift();
    points.middleRows(k * nv, nv) = wall.vertices;
    points.middleRows(k * nv, nv).leftCols(2).rowwise() += centres.row(k);
    triangles.middleRows(k * nf, nf) = wall.triangles.array() + static_cast<int>(k * nv);
    ++k;
  }
  context.out.write_matrix("/pillars/centres_um", centres * um_per_lu, "um", "centres of the pillars");
  context.out.write_matrix("/pillars/points_um", points * um_per_lu, "um", "vertices of the pillars' walls");
  context.out.write_matrix("/pillars/triangles", triangles, "none", "vertices of each triangle");
  context.xdmf.fixed.push_back({.name = "pillars",
                                .points = "/pillars/points_um",
                                .cells = "/pillars/triangles",
                                .n_points = static_cast<std::size_t>(count * nv),
                                .n_cells = static_cast<std::size_t>(count * nf),
                                .fields = {}});
}

}  // namespace dld
