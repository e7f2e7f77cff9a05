/// Pillar shapes: distance, area, gap and gap line against analytic values and brute force over the outline.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/circle.hpp"
#include "geometry/contour_pillar.hpp"
#include "geometry/device.hpp"
#include "geometry/ellipse.hpp"
#include "geometry/no_pillar.hpp"

namespace dld {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double spacing = 0.01;  // of the points by which the surface is searched

PillarValues values_of(const std::string& shape,
                       std::map<std::string, std::vector<double>, std::less<>> given) {
  PillarValues pillar{shape, std::move(given)};
  for (const PillarParameter& p : pillar_parameters(shape)) {
    if (p.fallback && !pillar.values.contains(p.name)) pillar.values[std::string(p.name)] = {*p.fallback};
  }
  return pillar;
}

struct Example {
  std::string name;
  PillarValues values;
};

const std::vector<double> ell_corners{-6, -6, 8, -6, 8, -2, -2, -2, -2, 9, -6, 9};

/// The example of every registered shape, and more: rounded and sharp, turned and not, convex and not.
std::vector<Example> examples() {
  std::vector<Example> all{
      {"circle", values_of("circle", {{"radius_um", {10}}})},
      {"ellipse", values_of("ellipse", {{"semi_axes_um", {12, 5}}})},
      {"tall ellipse, turned", values_of("ellipse", {{"semi_axes_um", {4, 9}}, {"rotation_deg", {30}}})},
      {"ellipse that is a circle", values_of("ellipse", {{"semi_axes_um", {7, 7}}, {"rotation_deg", {11}}})},
      {"triangle", values_of("polygon", {{"sides", {3}}, {"circumradius_um", {10}}})},
      {"rounded triangle, turned",
       values_of(
           "polygon",
           {{"sides", {3}}, {"circumradius_um", {10}}, {"rotation_deg", {90}}, {"corner_radius_um", {1.5}}})},
      {"rounded square",
       values_of(
           "polygon",
           {{"sides", {4}}, {"circumradius_um", {10}}, {"rotation_deg", {45}}, {"corner_radius_um", {2}}})},
      {"hexagon", values_of("polygon", {{"sides", {6}}, {"circumradius_um", {8}}, {"rotation_deg", {13}}})},
      {"teardrop", values_of("teardrop", {{"length_um", {18}}, {"width_um", {8}}, {"rotation_deg", {-20}}})},
      {"rounded I", values_of("i", {{"width_um", {14}},
                                    {"height_um", {18}},
                                    {"web_um", {4}},
                                    {"flange_um", {3}},
                                    {"corner_radius_um", {1}},
                                    {"rotation_deg", {10}}})},
      {"L", values_of("l", {{"width_um", {14}}, {"height_um", {18}}, {"stem_um", {5}}, {"foot_um", {4}}})},
      {"outline", values_of("outline", {{"points_um", ell_corners}})},
      {"rounded outline", values_of("outline", {{"points_um", ell_corners}, {"corner_radius_um", {1}}})},
  };
  for (const std::string& shape : pillar_shape_names())
    if (make_pillar(pillar_example(shape))->area() > 0)
      all.push_back({"example of " + shape, pillar_example(shape)});
  return all;
}

/// Many points of the surface: the outline with its chords cut; those of curves are moved onto the surface
/// along the normal of the chord by bisection, by the sign of the distance alone.
std::vector<Point2> surface_points(const PillarShape& shape) {
  std::vector<Point2> points;
  const auto outline = shape.outline();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    const bool straight = std::abs(shape.signed_distance(a[0] + dx / 2, a[1] + dy / 2)) < 1e-9;
    const int pieces = 1 + static_cast<int>(length / spacing);
    for (int k = 0; k < pieces; ++k) {
      const double x = a[0] + dx * k / pieces, y = a[1] + dy * k / pieces;
      double inside = -0.03, outside = 0.03;  // along the normal on the right, the outside
      for (int step = 0; step < 40 && !straight && k > 0; ++step) {
        const double middle = 0.5 * (inside + outside);
        const double d = shape.signed_distance(x + middle * dy / length, y - middle * dx / length);
        (d < 0 ? inside : outside) = middle;
      }
      const double off = straight || k == 0 ? 0 : outside;
      points.push_back({x + off * dy / length, y - off * dx / length});
    }
  }
  return points;
}

/// Crossing number of a ray, for points away from the surface.
bool is_inside(const std::vector<Point2>& points, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const Point2 &a = points[i], &b = points[j];
    if ((a[1] > y) != (b[1] > y) && x < (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) + a[0]) inside = !inside;
  }
  return inside;
}

TEST(Shapes, DistanceIsThatToTheNearestPointOfTheSurface) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-16, 16);
  for (const Example& e : examples()) {
    const auto shape = make_pillar(e.values);
    const auto points = surface_points(*shape);
    for (int k = 0; k < 250; ++k) {
      const double x = place(random), y = place(random);
      double nearest = 1e300;
      for (const Point2& p : points) nearest = std::min(nearest, std::hypot(x - p[0], y - p[1]));
      const double distance = shape->signed_distance(x, y);
      ASSERT_NEAR(std::abs(distance), nearest, 0.51 * spacing) << e.name << " at " << x << ", " << y;
      ASSERT_LE(std::abs(distance), nearest + 1e-9) << e.name << " at " << x << ", " << y;
      if (nearest > spacing) {
        ASSERT_EQ(distance < 0, is_inside(points, x, y)) << e.name << " at " << x << ", " << y;
      }
    }
  }
}

TEST(Shapes, TheDistanceHasSlopeOneAndItsGradientLeadsToTheSurface) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-15, 15);
  for (const Example& e : examples()) {
    const auto shape = make_pillar(e.values);
    int smooth = 0;
    for (int k = 0; k < 400; ++k) {
      const double x = place(random), y = place(random), h = 1e-5;
      const double d = shape->signed_distance(x, y);
      const double gx = (shape->signed_distance(x + h, y) - shape->signed_distance(x - h, y)) / (2 * h);
      const double gy = (shape->signed_distance(x, y + h) - shape->signed_distance(x, y - h)) / (2 * h);
      if (std::abs(std::hypot(gx, gy) - 1) > 1e-4) continue;  // on the medial line
      ++smooth;
      EXPECT_NEAR(shape->signed_distance(x - d * gx, y - d * gy), 0, 2e-3) << e.name << " " << x << ", " << y;
    }
    EXPECT_GE(smooth, 395) << e.name;
  }
}

TEST(Shapes, OutlineLiesOnTheSurfaceAndEnclosesTheArea) {
  for (const Example& e : examples()) {
    const auto shape = make_pillar(e.values);
    for (const Point2& p : shape->outline()) {
      EXPECT_NEAR(shape->signed_distance(p[0], p[1]), 0, 1e-9) << e.name;
      EXPECT_LE(std::hypot(p[0], p[1]), shape->bounding_radius() + 1e-12) << e.name;
    }
    EXPECT_NEAR(polygon_area(surface_points(*shape)) / shape->area(), 1, 1e-6) << e.name;
  }
}

TEST(Shapes, AnalyticAreas) {
  EXPECT_NEAR(make_pillar(values_of("ellipse", {{"semi_axes_um", {12, 5}}}))->area(), pi * 60, 1e-12);
  // Equilateral triangle of circumradius R: 3 sqrt(3) / 4 R^2; each rounded corner loses r^2 (sqrt(3) -
  // pi/3).
  const double r = 1.5;
  EXPECT_NEAR(make_pillar(values_of("polygon", {{"sides", {3}}, {"circumradius_um", {10}}}))->area(),
              75 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(make_pillar(values_of("polygon",
                                    {{"sides", {3}}, {"circumradius_um", {10}}, {"corner_radius_um", {r}}}))
                  ->area(),
              75 * std::sqrt(3.0) - 3 * r * r * (std::sqrt(3.0) - pi / 3), 1e-12);
}

TEST(Shapes, TeardropIsACircleWithItsTangentsToTheTail) {
  const double length = 18, nose = 4, tail = length - nose, angle = std::asin(nose / tail);
  const auto drop = make_pillar(values_of("teardrop", {{"length_um", {length}}, {"width_um", {2 * nose}}}));
  EXPECT_NEAR(drop->area(), nose * std::sqrt(tail * tail - nose * nose) + nose * nose * (pi / 2 + angle),
              1e-10);
  const double centre = nose - length / 2;
  for (double t = pi / 2; t < 3 * pi / 2; t += 0.1) {
    const double x = centre + 7 * std::cos(t), y = 7 * std::sin(t);
    EXPECT_NEAR(drop->signed_distance(x, y), 3, 1e-9) << t;
  }
  EXPECT_NEAR(drop->signed_distance(length / 2 + 2, 0), 2, 1e-9);
  EXPECT_NEAR(drop->signed_distance(centre, 0), -nose, 1e-9);
}

TEST(Shapes, AreasOfBars) {
  EXPECT_NEAR(make_pillar(values_of("i", {{"width_um", {14}},
                                          {"height_um", {18}},
                                          {"web_um", {4}},
                                          {"flange_um", {3}},
                                          {"rotation_deg", {33}}}))
                  ->area(),
              2 * 14 * 3 + 4 * 12, 1e-10);
  EXPECT_NEAR(
      make_pillar(
          values_of("l", {{"width_um", {14}}, {"height_um", {18}}, {"stem_um", {5}}, {"foot_um", {4}}}))
          ->area(),
      5 * 18 + 9 * 4, 1e-10);
}

/// A point-symmetric corner case: on the axes of an ellipse, inside and outside, the distance is known.
TEST(Shapes, EllipseOnItsAxes) {
  const Ellipse ellipse(12, 5, 0);
  EXPECT_NEAR(ellipse.signed_distance(0, 0), -5, 1e-12);
  EXPECT_NEAR(ellipse.signed_distance(0, 9), 4, 1e-12);
  EXPECT_NEAR(ellipse.signed_distance(0, -4), -1, 1e-12);
  EXPECT_NEAR(ellipse.signed_distance(-20, 0), 8, 1e-12);
  EXPECT_NEAR(ellipse.signed_distance(11.5, 0), -0.5, 1e-12);  // beyond the centre of curvature a - b^2/a
  const double c = 6 * 12.0 / (144 - 25), x = 12 * c, y = 5 * std::sqrt(1 - c * c);
  EXPECT_NEAR(ellipse.signed_distance(6, 0), -std::hypot(x - 6, y), 1e-12);
  const Circle circle(7);
  const Ellipse round(7, 7, 0.3);
  for (double t = -10; t < 10; t += 0.37)
    EXPECT_NEAR(round.signed_distance(t, 3), circle.signed_distance(t, 3), 1e-11);
}

TEST(Device, AnswersForTheCircleWhatThePaperDefines) {
  const Device device(std::make_shared<const Circle>(10), 32, 32, 3.2, 4.8);
  EXPECT_EQ(device.gap(), 12);
  EXPECT_EQ(device.narrowest_gap(), 12);
  EXPECT_EQ(device.gap_line().x, 0);
  EXPECT_EQ(device.gap_line().lower, 10);
  EXPECT_EQ(device.gap_line().upper, 22);
  EXPECT_EQ(device.start_x(), -16);
  EXPECT_NEAR(device.open_area(), 32 * 32 - 100 * pi, 1e-12);
  EXPECT_EQ(length_scale(device.gap(), device.depth()), std::sqrt(12 * 4.8));
}

Device device_of(const PillarValues& pillar, double pitch_y = 32) {
  return {make_pillar(pillar), 32, pitch_y, 3.2, 4.8};
}

TEST(Device, GapAndGapLineOfShapesAgreeWithGeometry) {
  // A corner towards +y over the flat side: 32 - 10 - 5 on the line through both.
  const Device triangle = device_of(values_of("polygon", {{"sides", {3}}, {"circumradius_um", {10}}}));
  EXPECT_NEAR(triangle.gap(), 17, 1e-9);
  EXPECT_EQ(triangle.gap_line().x, 0);
  EXPECT_NEAR(triangle.gap_line().lower, 10, 1e-9);
  EXPECT_NEAR(triangle.gap_line().upper, 27, 1e-9);
  // The corner towards -x: the flat side on the right is where the lane is narrowest.
  const Device turned =
      device_of(values_of("polygon", {{"sides", {3}}, {"circumradius_um", {10}}, {"rotation_deg", {90}}}));
  EXPECT_NEAR(turned.gap_line().x, 5, 1e-3);
  EXPECT_NEAR(turned.gap_line().upper - turned.gap_line().lower, 32 - 10 * std::sqrt(3.0), 1e-2);
  EXPECT_NEAR(turned.gap(), 32 - 10 * std::sqrt(3.0), 1e-9);
  // Pitches along and across: only the one across counts.
  EXPECT_NEAR(device_of(values_of("ellipse", {{"semi_axes_um", {12, 5}}}), 24).gap(), 14, 1e-9);
  // An ell: a stretch of the widest part, whose middle is taken.
  const GapLine line = device_of(values_of("outline", {{"points_um", ell_corners}})).gap_line();
  EXPECT_NEAR(line.x, -4, 0.05);
  EXPECT_NEAR(line.lower, 9, 1e-9);
  EXPECT_NEAR(line.upper, 26, 1e-9);
  EXPECT_NEAR(line.pillar_middle(32), 1.5, 1e-9);
}

TEST(Device, RoomOnALine) {
  const Device device(std::make_shared<const Circle>(10), 32, 32, 0, 4.8);
  EXPECT_NEAR(device.room_on_line(0), 6, 1e-9);
  EXPECT_NEAR(device.room_on_line(-16), 16 * std::sqrt(2.0) - 10, 1e-9);
  EXPECT_NEAR(device.thinnest_extent(), 20, 0.01);
  EXPECT_NEAR(device_of(values_of("ellipse", {{"semi_axes_um", {10, 0.3}}})).thinnest_extent(), 0.6, 1e-6);
}

/// Two copies of a tilted ellipse are nearest beside the line of their centres: brute force over the surface.
TEST(Device, GapIsTheShortestDistance) {
  for (const Example& e : examples()) {
    const auto shape = make_pillar(e.values);
    double nearest = 1e300;
    for (const Point2& p : surface_points(*shape))
      nearest = std::min(nearest, shape->signed_distance(p[0] - 3, p[1] - 30));
    EXPECT_NEAR(shape->gap(3, 30), nearest, 1e-4) << e.name;
    EXPECT_LE(shape->gap(3, 30), nearest + 1e-9) << e.name;
  }
}

TEST(PillarArray, DistanceOfAnyShapeIsThatToTheNearestOfAllImages) {
  for (const Example& e : examples()) {
    const std::shared_ptr<const PillarShape> shape = make_pillar(e.values);
    const PillarArray array(shape, 32, 27, 5);
    for (double x = -60; x < 60; x += 3.3) {
      for (double y = -60; y < 60; y += 4.7) {
        double nearest = 1e300;
        for (int n = -4; n <= 4; ++n)
          for (int m = -5; m <= 5; ++m)
            nearest = std::min(nearest, shape->signed_distance(x - n * 32, y - m * 27 - n * 5));
        ASSERT_NEAR(array.signed_distance(x, y), nearest, 1e-10) << e.name << " at " << x << ", " << y;
      }
    }
  }
}

TEST(Shapes, OutlinesThatAreNoneAreRefused) {
  const auto problems = [](std::vector<double> points, double radius = 0) {
    return pillar_problems(values_of("outline", {{"points_um", points}, {"corner_radius_um", {radius}}}));
  };
  EXPECT_TRUE(problems({0, 0, 4, 0, 0, 4}).empty());
  EXPECT_FALSE(problems({0, 0, 4, 0}).empty());                          // no area
  EXPECT_FALSE(problems({0, 0, 0, 4, 4, 0}).empty());                    // clockwise
  EXPECT_FALSE(problems({0, 0, 4, 0, 0, 4, 0, 0}).empty());              // first point repeated
  EXPECT_FALSE(problems({0, 0, 4, 4, 4, 0, 0, 4}).empty());              // crosses itself
  EXPECT_FALSE(problems({0, 0, 8, 0, 8, 4, 4, 0, 0, 4}).empty());        // touches itself
  EXPECT_FALSE(problems({0, 0, 4, 0, 6, 0, 4, 0, 4, 4, 0, 4}).empty());  // runs back
  EXPECT_FALSE(problems({0, 0, 4, 0, 4, 4, 0, 4}, 2.1).empty());         // radius too large
  EXPECT_TRUE(problems({0, 0, 4, 0, 4, 4, 0, 4}, 2.0).empty());
  // A notch that reaches into what is cut off the corner at the origin.
  EXPECT_FALSE(problems({0, 0, 20, 0, 20, 20, 0.9, 1, 0, 20}, 6).empty());
  EXPECT_FALSE(
      pillar_problems(
          values_of("polygon", {{"sides", {3}}, {"circumradius_um", {10}}, {"corner_radius_um", {5.1}}}))
          .empty());
}

}  // namespace
}  // namespace dld
