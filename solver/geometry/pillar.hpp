#pragma once
/// Pillar shapes behind one signed-distance interface. A new shape is one file with a class, which declares
/// its own parameters, and one line in the registry (pillar.cpp); nothing outside the file of a shape may
/// assume what it looks like.
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dld {

using Point2 = std::array<double, 2>;

/// What a shape says about one of its parameters; reader, echo and JSON Schema follow from it.
struct PillarParameter {
  enum class Kind { number, whole, pair, points };  ///< values: 1, 1, 2, or x and y of each point in turn
  std::string_view name;
  Kind kind = Kind::number;
  std::optional<double> fallback = {};  ///< value when it is not given; none: it has to be given
  /// Of the shape that pictures and the tests of every shape show; needed where there is no fallback. It fits
  /// a pitch of 32 um.
  std::vector<double> example = {};
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool open_minimum = false;   ///< the minimum itself is not allowed
  std::string_view unit = {};  ///< "um": a length, "degrees"; empty for a number without one
  std::string_view doc = {};
};

/// A pillar as a case describes it: the shape's name and the values of its parameters. Lengths are in the
/// unit of the caller (um in a case, lattice units in the solver), whatever the parameter's name ends in.
struct PillarValues {
  std::string shape;
  std::map<std::string, std::vector<double>, std::less<>> values = {};

  double number(std::string_view name) const;
  std::vector<Point2> points(std::string_view name) const;
  bool operator==(const PillarValues&) const = default;
};

/// Why values that are each within their own range make no pillar.
struct PillarProblem {
  std::string parameter, value, allowed, advice;
};

/// Cross-section of one pillar about its centre, the origin (pillars are prisms along z).
class PillarShape {
 public:
  virtual ~PillarShape() = default;
  /// Distance from (x, y) to the surface, negative inside.
  virtual double signed_distance(double x, double y) const = 0;
  /// Radius of a circle about the origin that holds the shape; negative if there is no pillar at all.
  virtual double bounding_radius() const = 0;
  virtual double area() const = 0;
  /// Points on the surface, counter-clockwise, with every corner and with curves in steps of at most
  /// `curve_step` (rad); the last joins the first. Empty if there is no pillar.
  virtual std::vector<Point2> outline() const = 0;
  /// Shortest distance between the pillar and its copy moved by (dx, dy); negative or zero if they meet.
  virtual double gap(double dx, double dy) const;

  static constexpr double curve_step = 0.0873;  // 5 degrees
};

/// Parameters of the shape of that name, in the order in which they are echoed; throws std::invalid_argument
/// for an unknown name.
std::vector<PillarParameter> pillar_parameters(const std::string& shape);

/// What the shape of that name is, for the schema.
std::string pillar_doc(const std::string& shape);

/// All that is wrong with complete values of which each is within its range.
std::vector<PillarProblem> pillar_problems(const PillarValues& values);

/// The shape of complete values without problems; throws std::invalid_argument for an unknown name.
std::unique_ptr<PillarShape> make_pillar(const PillarValues& values);

/// The shape of that name as its parameters' examples and defaults make it.
PillarValues pillar_example(const std::string& shape);

/// Registered names, in the order of the registry.
std::vector<std::string> pillar_shape_names();

}  // namespace dld
