#include "measure/streamlines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using Eigen::Vector2d;

constexpr double kPitch = 80, kRadius = 25;
constexpr dld::GapLine kGap{0, kRadius, kPitch - kRadius};

/// Signed distance to the nearest circular pillar of the array, its centre in (cx, cy).
struct Nearest {
  double distance, cx, cy;
};
Nearest nearest_pillar(double x, double y, double d) {
  Nearest best{HUGE_VAL, 0, 0};
  const double n0 = std::round(x / kPitch);
  for (double n = n0 - 1; n <= n0 + 1; ++n) {
    const double cx = n * kPitch, cy = n * d + kPitch * std::round((y - n * d) / kPitch);
    const double phi = std::hypot(x - cx, y - cy) - kRadius;
    if (phi < best.distance) best = {phi, cx, cy};
  }
  return best;
}

/// Flow with a known stream function: psi = psi_p + (1 - exp(-(phi/delta)^2)) (psi_0 - psi_p), psi_p = y of
/// the centre of the nearest pillar, psi_0 = y + a cos(2 pi (y - x d/nx)/ny). No slip, and every pillar lies
/// on the level psi_p, so the separatrices are level lines. a = 0 makes it point-symmetric about the gap
/// centre.
struct KnownFlow {
  double d, asymmetry = 0, delta = 4;

  double psi(double x, double y) const {
    const Nearest p = nearest_pillar(x, y, d);
    const double base = y + asymmetry * std::cos(2 * std::numbers::pi * (y - x * d / kPitch) / kPitch);
    return p.cy - std::expm1(-p.distance * p.distance / (delta * delta)) * (base - p.cy);
  }
  Vector2d velocity(double x, double y) const {
    if (nearest_pillar(x, y, d).distance <= 0) return Vector2d::Zero();
    constexpr double h = 1e-5;
    return {(psi(x, y + h) - psi(x, y - h)) / (2 * h), -(psi(x + h, y) - psi(x - h, y)) / (2 * h)};
  }
  dld::PlaneFlow flow() const {
    const KnownFlow copy = *this;
    return {[copy](double x, double y) { return copy.velocity(x, y); },
            [copy](double x, double y) { return nearest_pillar(x, y, copy.d).distance; },
            kPitch,
            kPitch,
            d,
            kGap};
  }
  /// y on the gap line where psi has this level.
  double gap_height(double level) const {
    double low = kRadius, high = kPitch - kRadius;
    for (int k = 0; k < 60; ++k) (psi(0, (low + high) / 2) < level ? low : high) = (low + high) / 2;
    return low;
  }
  /// Shortest distance between pillar (0,0) and the level line, by a scan over the angle.
  double shortest_distance(double level) const {
    double shortest = HUGE_VAL;
    for (double angle = 0.7; angle < 2.4; angle += 1e-4) {
      double low = kRadius, high = kRadius + 14;
      const double c = std::cos(angle), s = std::sin(angle);
      for (int k = 0; k < 40; ++k) {
        const double r = (low + high) / 2;
        (psi(r * c, r * s) < level ? low : high) = r;
      }
      if (high < kRadius + 13.9) shortest = std::min(shortest, low - kRadius);
    }
    return shortest;
  }
  /// Sampled on nodes whose node (0,0) lies at (x0, y0).
  dld::PlaneField sampled(double x0, double y0, bool with_distance = true) const {
    const int n = static_cast<int>(kPitch);
    Eigen::ArrayXXd u(n, n), v(n, n);
    dld::SolidFlags solid(n, n);
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const Vector2d w = velocity(i + x0, j + y0);
        u(i, j) = w.x();
        v(i, j) = w.y();
        solid(i, j) = nearest_pillar(i + x0, j + y0, d).distance <= 0;
      }
    }
    return {
        u, v, solid, x0, y0, static_cast<int>(d), with_distance ? flow().distance : dld::DistanceFunction{}};
  }
};

TEST(PlaneField, RepeatsWithTheShift) {
  const dld::PlaneField field = KnownFlow{15, 4}.sampled(-40, -39.5);
  for (const Vector2d& r :
       {Vector2d(3.3, 38.1), Vector2d(-38.7, 12.2), Vector2d(39.2, 27.9), Vector2d(1, 26)}) {
    const Vector2d u = field.velocity(r.x(), r.y());
    EXPECT_LT((field.velocity(r.x() + kPitch, r.y() + 15) - u).norm(), 1e-12);
    EXPECT_LT((field.velocity(r.x() - 2 * kPitch, r.y() - 30 + kPitch) - u).norm(), 1e-12);
  }
}

TEST(PlaneField, BicubicReproducesCubics) {
  const int n = 20;
  Eigen::ArrayXXd u(n, n), v(n, n);
  const auto cubic = [](double x, double y) { return 1 + x * x * x - 2 * x * y * y + y * y * y / 3; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      u(i, j) = cubic(i * 0.1, j * 0.1);
      v(i, j) = 2 * i - j;
    }
  }
  const dld::PlaneField field(u, v, dld::SolidFlags::Zero(n, n), 0, 0, 3);
  const Vector2d w = field.velocity(7.3, 11.8);
  EXPECT_NEAR(w.x(), cubic(0.73, 1.18), 1e-12);
  EXPECT_NEAR(w.y(), 2 * 7.3 - 11.8, 1e-12);
}

/// Flow round a resting cylinder inside a turning one, u_theta = r - R^2/r: largest error in the first two
/// lattice spacings off the wall, relative to the speed there.
TEST(PlaneField, WallFitOnCylindricalCouetteFlow) {
  const int n = 80;
  const double r0 = 25.3;
  const auto exact = [&](double x, double y) {
    const double r2 = x * x + y * y;
    return r2 > r0 * r0 ? Vector2d((1 - r0 * r0 / r2) * Vector2d(-y, x)) : Vector2d(Vector2d::Zero());
  };
  Eigen::ArrayXXd u(n, n), v(n, n);
  dld::SolidFlags solid(n, n);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Vector2d w = exact(i - 40, j - 40);
      u(i, j) = w.x();
      v(i, j) = w.y();
      solid(i, j) = std::hypot(i - 40, j - 40) <= r0;
    }
  }
  const dld::PlaneField field(u, v, solid, -40, -40, 0,
                              [&](double x, double y) { return std::hypot(x, y) - r0; });
  double fit_error = 0, bilinear_error = 0;
  for (double angle = 0; angle < 6.28; angle += 0.0137) {
    for (const double off : {0.05, 0.3, 0.8, 1.4, 2.0}) {
      const double x = (r0 + off) * std::cos(angle), y = (r0 + off) * std::sin(angle);
      const Vector2d w = exact(x, y);
      fit_error = std::max(fit_error, (field.velocity(x, y) - w).norm() / w.norm());
      bilinear_error = std::max(bilinear_error, (field.velocity_bilinear(x, y) - w).norm() / w.norm());
    }
  }
  EXPECT_LT(fit_error, 1e-3);
  EXPECT_GT(bilinear_error, 0.1);  // what the fit is there for
  EXPECT_EQ(field.velocity(r0 - 0.01, 0).norm(), 0);
}

TEST(Streamline, KeepsTheStreamFunction) {
  const KnownFlow known{15, 4};
  const dld::Streamline s = dld::trace_streamline(known.flow(), {0, 35}, +1, 3 * kPitch);
  ASSERT_EQ(s.end, dld::StreamlineEnd::line);
  for (Eigen::Index k = 0; k < s.points.rows(); k += 20) {
    EXPECT_NEAR(known.psi(s.points(k, 0), s.points(k, 1)), known.psi(0, 35), 1e-4);
  }
  EXPECT_DOUBLE_EQ(s.points(s.points.rows() - 1, 0), 3 * kPitch);
}

TEST(Separation, KnownSeparatrixAndSymmetry) {
  for (const double d : {5.0, 22.0}) {
    const KnownFlow known{d};
    const dld::Separation down = dld::separation_downstream(known.flow());
    const dld::Separation up = dld::separation_upstream(known.flow());
    ASSERT_TRUE(down.found && up.found);
    EXPECT_NEAR(down.seed_distance, known.gap_height(d) - kRadius, 1e-4) << d;
    EXPECT_NEAR(up.seed_distance, down.seed_distance, 1e-4) << d;
    EXPECT_NEAR(up.seed.y() + down.seed.y(), kPitch, 1e-4) << d;
    EXPECT_NEAR(down.minimum_distance, down.seed_distance, 2e-3) << d;
  }
}

TEST(Separation, AsymmetricFlowHasTwoSeparatrices) {
  const KnownFlow known{15, 4};
  const dld::Separation down = dld::separation_downstream(known.flow());
  const dld::Separation up = dld::separation_upstream(known.flow());
  EXPECT_NEAR(down.seed_distance, known.gap_height(15) - kRadius, 1e-4);
  EXPECT_NEAR(up.seed_distance, kPitch - kRadius - known.gap_height(kPitch - 15), 1e-4);
  EXPECT_GT(std::abs(up.seed_distance - down.seed_distance), 0.1);
  EXPECT_NEAR(down.minimum_distance, known.shortest_distance(15), 2e-3);
}

TEST(Separation, StreamlineEndsInTheStagnationPoints) {
  const KnownFlow known{15};
  const dld::Separation down = dld::separation_downstream(known.flow());
  const dld::Separation up = dld::separation_upstream(known.flow());
  const Vector2d front = down.streamline.row(down.streamline.rows() - 1);
  const Vector2d rear = up.streamline.row(0);
  EXPECT_LT((front - Vector2d(kPitch - kRadius, 15)).norm(), 0.5);
  EXPECT_LT((rear - Vector2d(-kPitch + kRadius, kPitch - 15)).norm(), 0.5);
  EXPECT_NEAR(down.streamline(0, 0), -kPitch / 2, 1e-9);
  EXPECT_NEAR(up.streamline(up.streamline.rows() - 1, 0), kPitch / 2, 1e-9);
}

TEST(Separation, SampledFieldComesCloseToTheKnownOne) {
  const KnownFlow known{15};
  const double exact = known.gap_height(15) - kRadius;
  for (const double origin : {-40.0, -39.5}) {  // pillar centre on a node and between nodes
    const dld::PlaneField field = known.sampled(origin, origin);
    const dld::Separation down = dld::separation_downstream(field.flow(kGap));
    const dld::Separation up = dld::separation_upstream(field.flow(kGap));
    EXPECT_NEAR(down.seed_distance, exact, 0.02) << origin;
    EXPECT_NEAR(up.seed_distance, down.seed_distance, 1e-3) << origin;
    RecordProperty("error", std::to_string(down.seed_distance - exact));
  }
}

TEST(Separation, SideIsKnownWhereTheStreamlineEndsOnTheWall) {
  const KnownFlow known{15};
  dld::StreamlineOptions coarse;
  coarse.wall_distance = 1;  // all streamlines near the separatrix end on the wall of pillar (1,0)
  const dld::Separation down = dld::separation_downstream(known.flow(), coarse);
  EXPECT_NEAR(down.seed_distance, known.gap_height(15) - kRadius, 1e-4);
}

TEST(Separation, NoRowShiftHasNoSeparatrix) {
  const KnownFlow known{0};
  const dld::Separation down = dld::separation_downstream(known.flow());
  EXPECT_FALSE(down.found);
  EXPECT_EQ(down.seed_distance, 0);
  EXPECT_EQ(down.streamline.rows(), 0);
  EXPECT_FALSE(dld::separation_upstream(known.flow()).found);
}

}  // namespace
