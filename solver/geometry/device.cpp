#include "geometry/device.hpp"

#include <limits>

namespace dld {
namespace {

/// The pillar on one line of constant x.
struct Chord {
  bool cut = false;
  double bottom = 0, top = 0;  ///< lowest and highest point of the pillar on the line
};

/// Walks from outside towards the pillar by its distance to it, which never leads beyond the surface.
bool walk(const PillarShape& shape, double x, double direction, double& y) {
  const double reach = shape.bounding_radius();
  y = -direction * reach;
  for (int k = 0; k < 2000; ++k) {
    const double distance = shape.signed_distance(x, y);
    if (distance <= 1e-12 * reach) return true;
    y += direction * distance;
    if (direction * y > reach) return false;
  }
  return true;
}

Chord chord(const PillarShape& shape, double x) {
  Chord c;
  c.cut = walk(shape, x, +1, c.bottom) && walk(shape, x, -1, c.top);
  return c;
}

/// Lines to try: those through the corners, and in between.
std::vector<double> lines(const PillarShape& shape) {
  constexpr int steps = 200;
  std::vector<double> x{0.0};
  for (const Point2& p : shape.outline()) x.push_back(p[0]);
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double first = *low, width = *high - *low;
  for (int k = 1; k < steps; ++k) x.push_back(first + width * k / steps);
  std::sort(x.begin(), x.end());
  return x;
}

}  // namespace

double Device::narrowest_gap() const {
  double narrowest = std::numeric_limits<double>::max();
  const double px = pillars_.pitch_x(), py = pillars_.pitch_y();
  narrowest = gap();
  // The other half of the neighbours is the same by symmetry.
  for (int m = -2; m <= 2; ++m) {
    narrowest = std::min(narrowest, pillars_.shape().gap(px, m * py + pillars_.row_shift()));
  }
  return narrowest;
}

double Device::thinnest_extent() const {
  const double pitch = pillars_.pitch_y();
  if (empty()) return pitch;
  double first = 0, last = 0;
  for (const Point2& p : pillars_.shape().outline())
    first = std::min(first, p[0]), last = std::max(last, p[0]);
  const GapLine gap = gap_line();
  return std::min(last - first, pitch - (gap.upper - gap.lower));
}

double Device::room_on_line(double x) const {
  constexpr int points = 400;
  double room = 0;
  for (int k = 0; k < points; ++k)
    room = std::max(room, pillars_.signed_distance(x, pillars_.pitch_y() * k / points));
  return room;
}

GapLine Device::gap_line() const {
  const double pitch = pillars_.pitch_y(), tolerance = 1e-6 * pitch;
  if (empty()) return {0, 0, pitch};
  const auto thickness = [&](double x) {
    const Chord c = chord(pillars_.shape(), x);
    return c.cut ? c.top - c.bottom : 0.0;
  };
  const std::vector<double> x = lines(pillars_.shape());
  std::vector<double> across(x.size());
  std::transform(x.begin(), x.end(), across.begin(), thickness);
  const double widest = *std::max_element(across.begin(), across.end());
  // Stretches of lines that are as narrow as the narrowest; the line of each nearest to the centre.
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (across[i] < widest - tolerance) continue;
    const std::size_t first = i;
    while (i + 1 < x.size() && across[i + 1] >= widest - tolerance) ++i;
    const double line = x[first] <= 0 && x[i] >= 0 ? 0.0 : 0.5 * (x[first] + x[i]);
    if (std::abs(line) < std::abs(best)) best = line;
  }
  const Chord c = chord(pillars_.shape(), best);
  return {best, c.top, pitch + c.bottom};
}

}  // namespace dld
