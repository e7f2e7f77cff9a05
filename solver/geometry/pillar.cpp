#include "geometry/pillar.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/circle.hpp"
#include "geometry/ellipse.hpp"
#include "geometry/i_shape.hpp"
#include "geometry/l_shape.hpp"
#include "geometry/no_pillar.hpp"
#include "geometry/outline.hpp"
#include "geometry/polygon.hpp"
#include "geometry/teardrop.hpp"

namespace dld {
namespace {

struct Entry {
  const char* name;
  const char* doc;
  std::vector<PillarParameter> (*parameters)();
  std::vector<PillarProblem> (*problems)(const PillarValues&);
  std::unique_ptr<PillarShape> (*make)(const PillarValues&);
};

template <class Shape>
Entry entry(const char* name) {
  return {name, Shape::doc, Shape::parameters, Shape::problems,
          [](const PillarValues& values) -> std::unique_ptr<PillarShape> {
            return std::make_unique<Shape>(Shape::from(values));
          }};
}

const std::vector<Entry>& registry() {
  // One line each, so that a new shape is a line of its own.
  // clang-format off
  static const std::vector<Entry> entries{
      entry<Circle>("circle"),
      entry<Ellipse>("ellipse"),
      entry<Polygon>("polygon"),
      entry<Teardrop>("teardrop"),
      entry<IShape>("i"),
      entry<LShape>("l"),
      entry<Outline>("outline"),
      entry<NoPillar>("none"),
  };
  // clang-format on
  return entries;
}

const Entry& find(const std::string& name) {
  for (const Entry& e : registry()) {
    if (name == e.name) return e;
  }
  throw std::invalid_argument("unknown pillar shape: " + name);
}

// Smallest value of a function that is convex on 0..1, by golden sections.
template <class Function>
double golden_minimum(const Function& f) {
  constexpr double ratio = 0.6180339887498949;
  double a = 0, b = 1, c = b - ratio * (b - a), d = a + ratio * (b - a), fc = f(c), fd = f(d);
  double smallest = std::min({f(a), f(b), fc, fd});
  for (int k = 0; k < 44; ++k) {
    if (fc < fd) {
      b = d, d = c, fd = fc, c = b - ratio * (b - a), fc = f(c);
    } else {
      a = c, c = d, fc = fd, d = a + ratio * (b - a), fd = f(d);
    }
    smallest = std::min({smallest, fc, fd});
  }
  return smallest;
}

}  // namespace

double PillarValues::number(std::string_view name) const {
  const auto found = values.find(name);
  if (found == values.end()) throw std::invalid_argument(shape + " has no " + std::string(name));
  return found->second.at(0);
}

std::vector<Point2> PillarValues::points(std::string_view name) const {
  const auto found = values.find(name);
  if (found == values.end()) throw std::invalid_argument(shape + " has no " + std::string(name));
  std::vector<Point2> list;
  for (std::size_t k = 0; k + 1 < found->second.size(); k += 2)
    list.push_back({found->second[k], found->second[k + 1]});
  return list;
}

// A point of the surface nearest to the copy: looked for along each chord of the outline, whose points are
// moved onto the surface by the exact distance. Chords that cannot hold it are left out (the distance has
// slope 1 at the most); long ones are cut, since the distance to a shape that is not convex has several
// minima.
double PillarShape::gap(double dx, double dy) const {
  constexpr int pieces = 4;
  const auto points = outline();
  const double h = 1e-6 * bounding_radius();
  const auto distance = [&](double x, double y) {
    const double d = signed_distance(x, y);
    const double gx = signed_distance(x + h, y) - signed_distance(x - h, y);
    const double gy = signed_distance(x, y + h) - signed_distance(x, y - h);
    const double norm = std::hypot(gx, gy);
    if (norm > 0) x -= d * gx / norm, y -= d * gy / norm;
    return signed_distance(x - dx, y - dy);
  };
  double shortest = std::numeric_limits<double>::max();
  for (const auto& p : points) shortest = std::min(shortest, signed_distance(p[0] - dx, p[1] - dy));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double at_a = signed_distance(a[0] - dx, a[1] - dy), at_b = signed_distance(b[0] - dx, b[1] - dy);
    if (0.5 * (at_a + at_b - 1.1 * length) > shortest) continue;
    for (int k = 0; k < pieces; ++k) {
      shortest = std::min(shortest, golden_minimum([&](double s) {
                            const double t = (k + s) / pieces;
                            return distance(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
                          }));
    }
  }
  return shortest;
}

std::vector<PillarParameter> pillar_parameters(const std::string& shape) {
  return find(shape).parameters();
}

std::string pillar_doc(const std::string& shape) {
  return find(shape).doc;
}

std::vector<PillarProblem> pillar_problems(const PillarValues& values) {
  return find(values.shape).problems(values);
}

std::unique_ptr<PillarShape> make_pillar(const PillarValues& values) {
  return find(values.shape).make(values);
}

PillarValues pillar_example(const std::string& shape) {
  PillarValues pillar{shape};
  for (const PillarParameter& p : find(shape).parameters()) {
    if (p.example.empty() && !p.fallback)
      throw std::logic_error(shape + ": " + std::string(p.name) + " needs an example");
    pillar.values[std::string(p.name)] = p.example.empty() ? std::vector<double>{*p.fallback} : p.example;
  }
  return pillar;
}

std::vector<std::string> pillar_shape_names() {
  std::vector<std::string> names;
  for (const Entry& e : registry()) names.emplace_back(e.name);
  return names;
}

}  // namespace dld
