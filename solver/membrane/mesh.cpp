#include "membrane/mesh.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

namespace dld {
namespace {

/// Point whose coordinates are p + q phi with whole p, q and the golden ratio phi: exact, so equal
/// points are found as equal and mirror images differ in sign bits only.
using GoldenPoint = std::array<int, 6>;

GoldenPoint combine(int i, const GoldenPoint& a, int j, const GoldenPoint& b, int k, const GoldenPoint& c) {
  GoldenPoint sum{};
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] = i * a[n] + j * b[n] + k * c[n];
  return sum;
}

Eigen::RowVector3d coordinates(const GoldenPoint& p) {
  constexpr double phi = std::numbers::phi;
  return {p[0] + phi * p[1], p[2] + phi * p[3], p[4] + phi * p[5]};
}

/// The 12 corners (0, +-1, +-phi) and their cyclic permutations.
std::vector<GoldenPoint> icosahedron_corners() {
  std::vector<GoldenPoint> corners;
  for (int axis = 0; axis < 3; ++axis) {
    for (int s : {-1, 1}) {
      for (int t : {-1, 1}) {
        GoldenPoint p{};
        p[static_cast<std::size_t>(2 * ((axis + 1) % 3))] = s;
        p[static_cast<std::size_t>(2 * ((axis + 2) % 3) + 1)] = t;
        corners.push_back(p);
      }
    }
  }
  return corners;
}

/// The 20 faces: triples of corners at the edge length 2, outward.
std::vector<std::array<GoldenPoint, 3>> icosahedron_faces() {
  const auto corners = icosahedron_corners();
  const auto adjacent = [&](std::size_t a, std::size_t b) {
    return (coordinates(corners[a]) - coordinates(corners[b])).norm() < 2.1;
  };
  std::vector<std::array<GoldenPoint, 3>> faces;
  for (std::size_t a = 0; a < 12; ++a) {
    for (std::size_t b = a + 1; b < 12; ++b) {
      for (std::size_t c = b + 1; c < 12; ++c) {
        if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(c, a)) continue;
        const auto pa = coordinates(corners[a]), pb = coordinates(corners[b]), pc = coordinates(corners[c]);
        const bool outward = pa.dot(pb.cross(pc)) > 0;
        faces.push_back({corners[a], corners[outward ? b : c], corners[outward ? c : b]});
      }
    }
  }
  return faces;
}

using Shape = std::function<TriangleMesh(int, double)>;

const std::vector<std::pair<std::string, Shape>>& cell_shapes() {
  static const std::vector<std::pair<std::string, Shape>> shapes = {
      {"red_blood_cell", red_blood_cell},
      {"sphere", sphere},
  };
  return shapes;
}

}  // namespace

TriangleMesh icosphere(int frequency) {
  if (frequency < 1) throw std::invalid_argument("mesh frequency must be at least 1");
  std::map<GoldenPoint, int> index_of;
  std::vector<GoldenPoint> points;
  std::vector<std::array<int, 3>> triangles;
  for (const auto& [a, b, c] : icosahedron_faces()) {
    const auto vertex = [&, &a = a, &b = b, &c = c](int i, int j) {
      const auto p = combine(frequency - i - j, a, i, b, j, c);
      const auto [entry, added] = index_of.try_emplace(p, static_cast<int>(points.size()));
      if (added) points.push_back(p);
      return entry->second;
    };
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
        if (i + j + 1 < frequency)
          triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
    }
  }
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  mesh.faces.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  // x^2 + y^2 + z^2 rounds the same for all mirror images, so the projection keeps their symmetry.
  for (std::size_t v = 0; v < points.size(); ++v) {
    mesh.vertices.row(static_cast<Eigen::Index>(v)) = coordinates(points[v]).normalized();
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    mesh.faces.row(static_cast<Eigen::Index>(f)) << triangles[f][0], triangles[f][1], triangles[f][2];
  }
  return mesh;
}

TriangleMesh sphere(int frequency, double radius) {
  TriangleMesh mesh = icosphere(frequency);
  mesh.vertices *= radius;
  return mesh;
}

TriangleMesh ellipsoid(int frequency, const Eigen::RowVector3d& semi_axes) {
  TriangleMesh mesh = icosphere(frequency);
  mesh.vertices *= semi_axes.asDiagonal();
  return mesh;
}

Eigen::MatrixX3d tilted(const Eigen::MatrixX3d& vertices, double tilt_deg) {
  const double tilt = tilt_deg * std::numbers::pi / 180.0;
  Eigen::Matrix3d turn;
  turn << std::cos(tilt), 0, -std::sin(tilt), 0, 1, 0, std::sin(tilt), 0, std::cos(tilt);
  return vertices * turn;
}

double evans_fung_profile(double q2) {
  constexpr double c0 = 0.207161, c2 = 2.002558, c4 = -1.122762;
  return 0.5 * (c0 + q2 * (c2 + q2 * c4));
}

TriangleMesh red_blood_cell(int frequency, double radius) {
  TriangleMesh mesh = icosphere(frequency);
  for (auto vertex : mesh.vertices.rowwise()) {
    // On the unit sphere Z = +-sqrt(1 - q^2), which carries the sign and the square root of the profile.
    vertex(2) *= evans_fung_profile(vertex.head<2>().squaredNorm());
  }
  mesh.vertices *= radius;
  return mesh;
}

TriangleMesh make_cell(const std::string& name, int frequency, double radius) {
  std::string known;
  for (const auto& [shape_name, shape] : cell_shapes()) {
    if (shape_name == name) return shape(frequency, radius);
    known += (known.empty() ? "" : ", ") + shape_name;
  }
  throw std::invalid_argument("unknown cell shape \"" + name + "\"; known shapes: " + known);
}

std::vector<std::string> cell_shape_names() {
  std::vector<std::string> names;
  for (const auto& entry : cell_shapes()) names.push_back(entry.first);
  return names;
}

std::vector<Edge> edges_of(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, std::size_t> waiting;  // directed edge of the first face -> its entry
  std::vector<Edge> edges;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int v1 = mesh.faces(f, k), v2 = mesh.faces(f, (k + 1) % 3), v3 = mesh.faces(f, (k + 2) % 3);
      const auto twin = waiting.find({v2, v1});
      if (twin != waiting.end()) {
        edges[twin->second].v4 = v3;
        edges[twin->second].opposite_face = f;
        waiting.erase(twin);
      } else if (waiting.try_emplace({v1, v2}, edges.size()).second) {
        edges.push_back({v1, v2, v3, -1, f, -1});
      } else {
        throw std::invalid_argument("mesh is not consistently oriented");
      }
    }
  }
  if (!waiting.empty()) throw std::invalid_argument("mesh is not closed");
  return edges;
}

std::string fingerprint(const TriangleMesh& mesh) {
  const auto hash = [](const auto& matrix) {
    using Matrix = std::decay_t<decltype(matrix)>;
    const std::string_view bytes(reinterpret_cast<const char*>(matrix.data()),
                                 sizeof(typename Matrix::Scalar) * static_cast<std::size_t>(matrix.size()));
    return std::to_string(std::hash<std::string_view>{}(bytes));
  };
  return hash(mesh.vertices) + " " + hash(mesh.faces);
}

Eigen::VectorXi mirror_images(const Eigen::MatrixX3d& vertices) {
  std::map<std::array<double, 3>, int> vertex_at;
  const int nv = static_cast<int>(vertices.rows());
  for (int v = 0; v < nv; ++v) vertex_at[{vertices(v, 0), vertices(v, 1), vertices(v, 2)}] = v;
  Eigen::VectorXi images(nv);
  for (int v = 0; v < nv; ++v) {
    const auto image = vertex_at.find({vertices(v, 0), vertices(v, 1), -vertices(v, 2)});
    if (image == vertex_at.end()) throw std::invalid_argument("the mesh is not mirror-symmetric about z = 0");
    images(v) = image->second;
  }
  return images;
}

}  // namespace dld
