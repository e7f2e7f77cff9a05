#pragma once
/// A slow and plain lattice Boltzmann solver: two arrays, one branch per link, full populations f_i in double
/// precision. It shares only the velocity set with the solver under test; walls are found analytically.
#include <array>
#include <cmath>
#include <vector>

#include "fluid/lattice.hpp"
#include "support/fluid_box.hpp"

namespace dld::test {

using Vector3 = std::array<double, 3>;

class NaiveFluid {
 public:
  NaiveFluid(const BoxSize& size, double origin_x, double origin_y, const FluidModel& model)
      : size_(size), x0_(origin_x), y0_(origin_y), model_(model) {
    const auto nodes = static_cast<std::size_t>(size.nx * size.ny * size.nz);
    tau.assign(nodes, model.relaxation_time);
    force.assign(nodes, {});
    velocity.assign(nodes, {});
    density.assign(nodes, 1.0);
    incoming_.assign(nodes, {});
    post_.assign(nodes, {});
    for (int x = 0; x < size.nx; ++x)
      for (int y = 0; y < size.ny; ++y)
        solid_.push_back(size.radius > 0 && nearest_pillar(x + x0_, y + y0_) <= size.radius);
  }

  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((x * size_.ny + y) * size_.nz + z);
  }

  bool solid(int x, int y) const { return solid_[static_cast<std::size_t>(x * size_.ny + y)]; }

  void initialise(int x, int y, int z, const Vector3& u) {
    for (int i = 0; i < 19; ++i) incoming_[index(x, y, z)][slot(i)] = equilibrium(i, 1.0, u);
  }

  /// Velocity and density before the collision are kept; then collide, then stream.
  void step() {
    for (int x = 0; x < size_.nx; ++x)
      for (int y = 0; y < size_.ny; ++y)
        for (int z = 0; z < size_.nz; ++z)
          if (!solid(x, y)) collide(index(x, y, z));
    for (int x = 0; x < size_.nx; ++x)
      for (int y = 0; y < size_.ny; ++y)
        for (int z = 0; z < size_.nz; ++z)
          if (!solid(x, y))
            for (int i = 0; i < 19; ++i) incoming_[index(x, y, z)][slot(i)] = streamed(i, x, y, z);
  }

  /// Density and velocity from the populations that the next step will collide.
  void update_moments(std::size_t n) {
    double rho = 0;
    Vector3 j{};
    for (int i = 0; i < 19; ++i) {
      rho += incoming_[n][slot(i)];
      const Vector3 c = direction(i);
      for (std::size_t d = 0; d < 3; ++d) j[d] += c[d] * incoming_[n][slot(i)];
    }
    density[n] = rho;
    for (std::size_t d = 0; d < 3; ++d) velocity[n][d] = (j[d] + 0.5 * force[n][d]) / (stokes() ? 1.0 : rho);
  }

  std::vector<double> tau, density;
  std::vector<Vector3> force, velocity;  ///< total force density; velocity before the last collision

 private:
  static std::size_t slot(int i) { return static_cast<std::size_t>(i); }
  static Vector3 direction(int i) {
    const auto c = d3q19::c[slot(i)];
    return {double(c.x), double(c.y), double(c.z)};
  }
  static double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  /// Direction with the same x, y and z times the given signs.
  static int reflected(int i, double sx, double sy, double sz) {
    const Vector3 c = direction(i);
    for (int k = 0; k < 19; ++k)
      if (direction(k) == Vector3{sx * c[0], sy * c[1], sz * c[2]}) return k;
    return -1;
  }
  static int opposite(int i) {
    static const std::array<int, 19> table = [] {
      std::array<int, 19> t{};
      for (int k = 0; k < 19; ++k) t[slot(k)] = reflected(k, -1, -1, -1);
      return t;
    }();
    return table[slot(i)];
  }
  static double weight(int i) {
    const double squared = dot(direction(i), direction(i));
    return squared == 0 ? 1.0 / 3 : squared == 1 ? 1.0 / 18 : 1.0 / 36;
  }
  bool stokes() const { return model_.equilibrium == EquilibriumModel::stokes; }

  double equilibrium(int i, double rho, const Vector3& u) const {
    const double cu = dot(direction(i), u);
    if (stokes()) return weight(i) * (rho + 3 * cu);
    return weight(i) * rho * (1 + 3 * cu + 4.5 * cu * cu - 1.5 * dot(u, u));
  }

  /// Guo's source without its prefactor: w [3 (c - u) + 9 (c.u) c] . F.
  double source(int i, const Vector3& u, const Vector3& f) const {
    const Vector3 c = direction(i);
    if (stokes()) return weight(i) * 3 * dot(c, f);
    return weight(i) * (3 * (dot(c, f) - dot(u, f)) + 9 * dot(c, u) * dot(c, f));
  }

  void collide(std::size_t n) {
    update_moments(n);
    const double viscous = tau[n];
    const double other =
        model_.collision == CollisionModel::bgk ? viscous : 0.5 + model_.magic_parameter / (viscous - 0.5);
    for (int i = 0; i < 19; ++i) {
      const int k = opposite(i);
      const auto half = [&](double a, double b) { return 0.5 * (a + b); };
      const double f = incoming_[n][slot(i)], g = incoming_[n][slot(k)];
      const double e = equilibrium(i, density[n], velocity[n]), h = equilibrium(k, density[n], velocity[n]);
      const double s = source(i, velocity[n], force[n]), t = source(k, velocity[n], force[n]);
      post_[n][slot(i)] = f - (half(f, g) - half(e, h)) / viscous - (half(f, -g) - half(e, -h)) / other +
                          (1 - 0.5 / viscous) * half(s, t) + (1 - 0.5 / other) * half(s, -t);
    }
  }

  /// Distance from (x, y) to the nearest pillar centre of the array.
  double nearest_pillar(double x, double y) const {
    double nearest = 1e300;
    for (int n = -3; n <= 3; ++n)
      for (int m = -3; m <= 3; ++m)
        nearest = std::min(nearest, std::hypot(x - n * size_.nx, y - m * size_.ny - n * size_.row_shift));
    return nearest;
  }

  struct Place {
    int x, y, z;
    bool mirrored, wall;
  };
  Place place(int x, int y, int z) const {
    bool mirrored = false;
    if (z >= size_.nz || z < 0) {
      if (size_.height == HeightBoundary::periodic) {
        z = (z + size_.nz) % size_.nz;
      } else if (z < 0 && size_.height == HeightBoundary::mirror_and_wall) {
        z = -1 - z;
        mirrored = true;
      } else {
        return {x, y, z, false, true};
      }
    }
    // Leaving at the right means entering at the left d lower.
    while (x >= size_.nx) x -= size_.nx, y -= size_.row_shift;
    while (x < 0) x += size_.nx, y += size_.row_shift;
    while (y >= size_.ny) y -= size_.ny;
    while (y < 0) y += size_.ny;
    return {x, y, z, mirrored, false};
  }

  double post_at(int i, const Place& p) const {
    return post_[index(p.x, p.y, p.z)][slot(p.mirrored ? reflected(i, 1, 1, -1) : i)];
  }

  /// Distance along c, in units of |c|, from node (x, y) to the first pillar surface.
  double wall_share(int x, int y, const Vector3& c) const {
    double share = 2.0;
    for (int n = -2; n <= 2; ++n)
      for (int m = -2; m <= 2; ++m) {
        const double px = x + x0_ - n * size_.nx, py = y + y0_ - m * size_.ny - n * size_.row_shift;
        const double a = c[0] * c[0] + c[1] * c[1], b = px * c[0] + py * c[1];
        const double d = b * b - a * (px * px + py * py - size_.radius * size_.radius);
        if (d < 0) continue;
        const double root = (-b - std::sqrt(d)) / a;
        if (root > 0) share = std::min(share, root);
      }
    return share;
  }

  double streamed(int i, int x, int y, int z) const {
    const auto c = d3q19::c[slot(i)];
    const Place from = place(x - c.x, y - c.y, z - c.z);
    const int out = opposite(i);
    const double back = post_[index(x, y, z)][slot(out)];
    if (from.wall) {
      const double speed = from.z < 0 ? model_.wall_motion.below : model_.wall_motion.above;
      return back + 6 * weight(i) * c.x * speed;
    }
    if (!solid(from.x, from.y)) return post_at(i, from);
    if (model_.walls == WallModel::half_way) return back;
    const double q = wall_share(x, y, direction(out));
    const double away = post_[index(x, y, z)][slot(i)];
    const bool central = model_.walls == WallModel::central_linear;
    if (!central && q >= 0.5) return back / (2 * q) + (1 - 1 / (2 * q)) * away;
    const Place behind = place(x + c.x, y + c.y, z + c.z);
    if (behind.wall || solid(behind.x, behind.y)) return back;
    const double cut = std::max(q, 0.1);  // no wall is nearer to a node than that
    if (central) return back + (1 - 2 * cut) / (1 + 2 * cut) * (post_at(out, behind) - away);
    return 2 * q * back + (1 - 2 * q) * post_at(out, behind);
  }

  BoxSize size_;
  double x0_, y0_;
  FluidModel model_;
  std::vector<bool> solid_;
  std::vector<std::array<double, 19>> incoming_, post_;
};

}  // namespace dld::test
