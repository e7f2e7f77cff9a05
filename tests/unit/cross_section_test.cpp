#include "measure/cross_section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

struct Surface {
  Eigen::MatrixX3d vertices;
  Eigen::MatrixX3i faces;
};

/// Ellipsoid with semi-axes a, b, c along x, y, z on a grid of meridians about the x axis. Every ring is cut
/// at phi = 0, 90, 180, 270 degrees, so that the section's extents are those of a polygon with known corners.
Surface ellipsoid(double a, double b, double c, int rings, int meridians) {
  Surface s;
  s.vertices.resize((rings - 1) * meridians + 2, 3);
  for (int i = 1; i < rings; ++i) {
    const double theta = std::numbers::pi * i / rings;
    for (int j = 0; j < meridians; ++j) {
      const double phi = 2 * std::numbers::pi * j / meridians;
      s.vertices.row((i - 1) * meridians + j) << -a * std::cos(theta), b * std::sin(theta) * std::cos(phi),
          c * std::sin(theta) * std::sin(phi);
    }
  }
  const int front = (rings - 1) * meridians, back = front + 1;
  s.vertices.row(front) << -a, 0, 0;
  s.vertices.row(back) << a, 0, 0;
  s.faces.resize(2 * (rings - 1) * meridians, 3);
  int f = 0;
  for (int j = 0; j < meridians; ++j) {
    const int k = (j + 1) % meridians, last = (rings - 2) * meridians;
    s.faces.row(f++) << front, k, j;
    s.faces.row(f++) << back, last + j, last + k;
    for (int i = 0; i + 2 < rings; ++i) {
      const int p = i * meridians;
      s.faces.row(f++) << p + j, p + k, p + meridians + j;
      s.faces.row(f++) << p + k, p + meridians + k, p + meridians + j;
    }
  }
  return s;
}

TEST(CrossSection, SphereExtentIsTheChord) {
  const Surface s = ellipsoid(10, 10, 10, 400, 16);
  for (const double x0 : {-9.0, -4.0, 0.0, 0.1, 7.0}) {
    const dld::CrossSection section = dld::cross_section(s.vertices, s.faces, x0);
    const double exact = 2 * std::sqrt(100 - x0 * x0);
    EXPECT_NEAR(section.width, exact, 2e-3 * exact) << x0;
    EXPECT_NEAR(section.height, exact, 2e-3 * exact) << x0;
    EXPECT_LE(section.width, exact + 1e-12);
  }
}

TEST(CrossSection, EllipsoidOffCentre) {
  Surface s = ellipsoid(12, 9, 3, 400, 16);
  s.vertices.col(0).array() += 80;
  s.vertices.col(1).array() += 33;
  const dld::CrossSection section = dld::cross_section(s.vertices, s.faces, 83);
  const double scale = std::sqrt(1 - 9.0 / 144);
  EXPECT_NEAR(section.width, 18 * scale, 1e-3);
  EXPECT_NEAR(section.height, 6 * scale, 1e-3);
  EXPECT_NEAR(section.min_y, 33 - 9 * scale, 1e-3);
  EXPECT_NEAR(section.max_z, 3 * scale, 1e-3);
}

TEST(CrossSection, ExactOnARingOfVertices) {
  const Surface s = ellipsoid(10, 8, 6, 40, 16);  // ring 20 lies at x = 0 up to rounding
  const dld::CrossSection section = dld::cross_section(s.vertices, s.faces, 0);
  EXPECT_NEAR(section.width, 16, 1e-12);
  EXPECT_NEAR(section.height, 12, 1e-12);
}

TEST(CrossSection, SegmentsFormAClosedOutline) {
  const Surface s = ellipsoid(10, 8, 6, 20, 16);
  for (const double x0 : {0.3, s.vertices(35, 0)}) {
    const dld::CrossSection section = dld::cross_section(s.vertices, s.faces, x0);
    // Divergence theorem on the unordered outline: each end is shared, so signed ends cancel after pairing.
    for (Eigen::Index k = 0; k < section.segments.rows(); ++k) {
      for (const int side : {0, 2}) {
        int shared = 0;
        const Eigen::RowVector2d end = section.segments.row(k).segment<2>(side);
        for (Eigen::Index m = 0; m < section.segments.rows(); ++m) {
          shared += (section.segments.row(m).head<2>() - end).norm() < 1e-12;
          shared += (section.segments.row(m).tail<2>() - end).norm() < 1e-12;
        }
        EXPECT_GE(shared, 2);
        EXPECT_EQ(shared % 2, 0);
      }
    }
  }
}

TEST(CrossSection, PlaneBesideTheCell) {
  const Surface s = ellipsoid(10, 8, 6, 20, 16);
  const dld::CrossSection section = dld::cross_section(s.vertices, s.faces, 10.5);
  EXPECT_EQ(section.width, 0);
  EXPECT_EQ(section.height, 0);
  EXPECT_EQ(section.segments.rows(), 0);
}

TEST(PassageExtent, MaximumCentreAndFilm) {
  // An ellipsoid tilted in the plane: its widest section along the passage is the one through its centre.
  const Surface s = ellipsoid(10, 5, 4, 200, 16);
  dld::PassageExtent passage(80);
  EXPECT_FALSE(passage.reached());
  for (long step = 0; step <= 100; ++step) {
    const Eigen::Vector3d centre(60.2 + 0.4 * static_cast<double>(step),
                                 30 + 0.01 * static_cast<double>(step), 0);
    const Eigen::MatrixX3d x = s.vertices.rowwise() + centre.transpose();
    const double film = 1 + std::abs(centre.x() - 80) / 10;
    passage.update(x, s.faces, centre, film, step);
    if (centre.x() < 69) {
      EXPECT_FALSE(passage.reached());
    }
    EXPECT_EQ(passage.centre_passed(), centre.x() >= 80);
    EXPECT_EQ(passage.passed(), centre.x() - 10 > 80);
  }
  EXPECT_NEAR(passage.max_width(), 10, 5e-3);
  EXPECT_NEAR(passage.width_at_centre(), 10, 5e-3);
  EXPECT_NEAR(passage.height_at_max(), 8, 5e-3);
  EXPECT_NEAR(passage.step_at_centre(), 49.5, 1e-9);
  EXPECT_NEAR(passage.y_at_centre(), 30.495, 1e-9);
  EXPECT_NEAR(passage.min_film(), 1.02, 1e-9);
  EXPECT_NEAR(passage.vertices_at_max().col(0).mean(), 80, 0.21);
}

// What a checkpoint keeps of a passage that is half over tells the rest of it to the last bit.
TEST(PassageExtent, GoesOnFromItsNumbers) {
  const Surface s = ellipsoid(10, 5, 4, 40, 16);
  for (long stop = 0; stop <= 100; stop += 10) {
    dld::PassageExtent whole(80), resumed(80);
    for (long step = 0; step <= 100; ++step) {
      const Eigen::Vector3d centre(60.2 + 0.4 * static_cast<double>(step), 30 + std::sin(0.1 * double(step)),
                                   0);
      const Eigen::MatrixX3d x = s.vertices.rowwise() + centre.transpose();
      whole.update(x, s.faces, centre, 1 + 0.1 * double(step % 7), step);
      if (step == stop) resumed = dld::PassageExtent::from(whole.numbers(), whole.vertices_at_max());
      if (step > stop) resumed.update(x, s.faces, centre, 1 + 0.1 * double(step % 7), step);
    }
    EXPECT_EQ(resumed.numbers(), whole.numbers()) << stop;
    EXPECT_EQ(resumed.vertices_at_max(), whole.vertices_at_max()) << stop;
    EXPECT_GT(resumed.max_width(), 0);
  }
  EXPECT_THROW(dld::PassageExtent::from({80, 1}, {}), std::invalid_argument);
}

}  // namespace
