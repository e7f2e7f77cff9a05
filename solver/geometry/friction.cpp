#include "geometry/friction.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dld {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

// Stiffness of the volume (in units of the viscosity) that stands for the pressure: the divergence that is
// left is below a millionth.
constexpr double bulk_viscosity = 1e6;
// Nearest that a wall is taken to be to a node, in cells.
constexpr double nearest_wall = 0.05;

// Marker-and-cell grid (Harlow and Welch 1965): u on the faces across x, v on those across y, p in the cells.
class Grid {
 public:
  explicit Grid(const ArrayGeometry& array) : array_(array) {
    constexpr double least = 24, most = 48, cells_per_gap = 8;
    constexpr int fewest = 8;  // along the shorter of two unequal pitches
    const double pitch = std::max(array.pitch_x, array.pitch_y);
    const double fine = std::clamp(cells_per_gap * pitch / array.gap, least, most) / pitch;
    nx = std::max(fewest, static_cast<int>(std::lround(fine * array.pitch_x)));
    ny = fitting_rows(std::max(fewest, static_cast<int>(std::lround(fine * array.pitch_y))));
    hx = array.pitch_x / nx;
    hy = array.pitch_y / ny;
    shift_ = static_cast<int>(std::lround(array.row_shift / hy));
  }

  int cells() const { return nx * ny; }
  /// Index of the place (i, j), which may lie one cell outside: phi(x + lambda, y) = phi(x, y - d).
  int at(int i, int j) const {
    const int turns = i < 0 ? -1 : i >= nx ? 1 : 0;
    const int row = (j - turns * shift_) % ny;
    return (i - turns * nx) * ny + (row + ny) % ny;
  }
  double distance(double i, double j) const {
    return array_.distance((i - 0.5 * nx) * hx, (j - 0.5 * ny) * hy);
  }

  int nx = 0, ny = 0;
  double hx = 0, hy = 0;

 private:
  // A number of cells near `rows` of which the row shift is a whole number, as nearly as can be.
  int fitting_rows(int rows) const {
    const auto misfit = [&](int n) {
      const double shift = array_.row_shift / array_.pitch_y * n;
      return std::abs(shift - std::round(shift));
    };
    int best = rows;
    for (int n = rows; n <= rows + 8; ++n) {
      if (misfit(n) < misfit(best) - 1e-9) best = n;
    }
    return best;
  }

  const ArrayGeometry& array_;
  int shift_ = 0;
};

// Share of a segment between two signed distances that is fluid.
double open_share(double a, double b) {
  if (a > 0 && b > 0) return 1;
  if (a <= 0 && b <= 0) return 0;
  return std::max(a, b) / (std::max(a, b) - std::min(a, b));
}

// One component of the velocity: `oi`, `oj` are the offsets of its places from the corners of the cells.
struct Component {
  double oi, oj;
  int first;                 ///< index of its first unknown
  std::vector<double> open;  ///< open share of each face, 0 where the place of the velocity is solid
};

Component component(const Grid& grid, double oi, double oj, int first) {
  Component c{oi, oj, first, std::vector<double>(static_cast<std::size_t>(grid.cells()))};
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      if (grid.distance(i + oi, j + oj) <= 0) continue;
      c.open[static_cast<std::size_t>(grid.at(i, j))] =
          open_share(grid.distance(i, j), grid.distance(i + 2 * oi, j + 2 * oj));
    }
  }
  return c;
}

// 12 u / H^2 - laplace u with the true distance of the walls (Shortley and Weller 1938).
void add_friction(const Grid& grid, const Component& c, double depth, Entries& entries) {
  constexpr std::array<std::array<int, 2>, 2> axes{{{1, 0}, {0, 1}}};
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      const int row = c.first + grid.at(i, j);
      const double here = grid.distance(i + c.oi, j + c.oj);
      if (here <= 0) {
        entries.emplace_back(row, row, 1.0);
        continue;
      }
      double diagonal = 12 / (depth * depth);
      for (const auto& [di, dj] : axes) {
        const double h = di != 0 ? grid.hx : grid.hy;
        std::array<double, 2> way{};
        std::array<bool, 2> fluid{};
        for (const int side : {0, 1}) {
          const int sign = 1 - 2 * side;
          const double there = grid.distance(i + sign * di + c.oi, j + sign * dj + c.oj);
          fluid[side] = there > 0;
          way[side] = fluid[side] ? 1.0 : std::max(here / (here - there), nearest_wall);
        }
        for (const int side : {0, 1}) {
          const int sign = 1 - 2 * side;
          const double weight = 2 / (h * h * way[side] * (way[0] + way[1]));
          diagonal += weight;
          if (fluid[side])
            entries.emplace_back(row, c.first + grid.at(i + sign * di, j + sign * dj), -weight);
        }
      }
      entries.emplace_back(row, row, diagonal);
    }
  }
}

// Pressure gradient and divergence of one component: p of the cell at (i, j) minus that of the cell before.
void add_pressure(const Grid& grid, const Component& c, Entries& gradient, Entries& divergence) {
  const int di = c.oi == 0 ? 1 : 0, dj = 1 - di;
  const double h = di != 0 ? grid.hx : grid.hy;
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      const int here = grid.at(i, j), before = grid.at(i - di, j - dj), unknown = c.first + here;
      const double open = c.open[static_cast<std::size_t>(here)];
      if (open == 0) continue;
      gradient.emplace_back(unknown, here, 1 / h);
      gradient.emplace_back(unknown, before, -1 / h);
      divergence.emplace_back(here, unknown, -open / h);
      divergence.emplace_back(before, unknown, open / h);
    }
  }
}

// Mean over the fluid of one component.
double mean(const Component& c, const Eigen::VectorXd& velocity, double open_area) {
  double sum = 0;
  for (std::size_t k = 0; k < c.open.size(); ++k) sum += c.open[k] * velocity[c.first + static_cast<int>(k)];
  return sum / (open_area * static_cast<double>(c.open.size()));
}

double open_area(const Grid& grid) {
  const double h = std::sqrt(grid.hx * grid.hy);
  double sum = 0;
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) sum += std::clamp(0.5 + grid.distance(i + 0.5, j + 0.5) / h, 0.0, 1.0);
  }
  return sum / grid.cells();
}

// Share of the pillars in the friction decides how flat the profile across the depth is: with friction 1 / k
// per area from the pillars alone it is 1 - cosh(z / sqrt k) / cosh(a), a = H / (2 sqrt k).
struct DepthProfile {
  double mean_over_parabola = 1;  ///< mean velocity over what 12 / H^2 + 1 / k gives
  double largest_over_mean = 1.5;
};

DepthProfile depth_profile(double depth, double friction) {
  // Fitted to the flow of the solver: part of the friction beyond the slit's is that of longer ways, which
  // leave the parabola as it is.
  constexpr double share = 0.6;
  const double pillars = std::max(0.0, friction - 12 / (depth * depth));
  const double a = 0.5 * depth * std::sqrt(pillars);
  if (a < 1e-3) return {};
  const double flat = 1 - std::tanh(a) / a;  // mean over the largest of a flow without bottom and top
  const double full = flat * (12 + 4 * a * a) / (4 * a * a);
  return {1 / (1 + share * (1 / full - 1)), (1 - 1 / std::cosh(a)) / flat};
}

}  // namespace

Mobility slit_mobility(double depth) {
  const double m = depth * depth / 12;
  return {.xx = m, .yy = m, .largest = 1.5 * m};
}

Mobility estimate_mobility(const ArrayGeometry& array) {
  const Grid grid(array);
  const int n = grid.cells();
  const Component u = component(grid, 0, 0.5, 0), v = component(grid, 0.5, 0, n);
  Entries friction, gradient, divergence;
  for (const Component* c : {&u, &v}) {
    add_friction(grid, *c, array.depth, friction);
    add_pressure(grid, *c, gradient, divergence);
  }
  Matrix a(2 * n, 2 * n), g(2 * n, n), d(n, 2 * n);
  a.setFromTriplets(friction.begin(), friction.end());
  g.setFromTriplets(gradient.begin(), gradient.end());
  d.setFromTriplets(divergence.begin(), divergence.end());
  // p = -bulk div u, and `d` is the negative divergence.
  const double bulk = bulk_viscosity;
  const Matrix pressure = bulk * (g * d);
  const Matrix whole = a + pressure;
  Eigen::SparseLU<Matrix> solver(whole);
  const double area = open_area(grid);
  std::array<Eigen::VectorXd, 2> flow;
  for (const int along : {0, 1}) {
    const Component& c = along == 0 ? u : v;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * n);
    for (int k = 0; k < n; ++k) force[c.first + k] = c.open[static_cast<std::size_t>(k)] > 0 ? 1.0 : 0.0;
    flow[static_cast<std::size_t>(along)] = solver.solve(force);
  }
  Mobility m{.xx = mean(u, flow[0], area),
             .xy = mean(u, flow[1], area),
             .yx = mean(v, flow[0], area),
             .yy = mean(v, flow[1], area),
             .open_area = area};
  const DepthProfile profile = depth_profile(array.depth, 1 / m.xx);
  m.largest = flow[0].head(n).maxCoeff() * profile.largest_over_mean;
  for (double* part : {&m.xx, &m.xy, &m.yx, &m.yy, &m.largest}) *part *= profile.mean_over_parabola;
  return m;
}

}  // namespace dld
