#include "membrane/mesh_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace dld {
namespace {

using Faults = std::vector<MeshFault>;

/// "3 faces (the first: 17)" for a list of numbers; "1 face (17)" for one.
std::string counted(const std::vector<int>& list, const std::string& name) {
  if (list.size() == 1) return "1 " + name + " (" + std::to_string(list.front()) + ")";
  const std::string plural = name == "vertex" ? "vertices" : name + "s";
  return std::to_string(list.size()) + " " + plural + " (the first: " + std::to_string(list.front()) + ")";
}

bool all_finite(const TriangleMesh& mesh, Faults& faults) {
  std::vector<int> wrong;
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    if (!mesh.vertices.row(v).allFinite()) wrong.push_back(v);
  }
  if (!wrong.empty())
    faults.push_back(
        {counted(wrong, "vertex") + " without finite coordinates", "numbers", "write them anew"});
  return wrong.empty();
}

void check_vertices(const TriangleMesh& mesh, Faults& faults) {
  std::set<std::array<double, 3>> seen;
  std::vector<bool> used(static_cast<std::size_t>(mesh.vertices.rows()), false);
  for (const int v : mesh.faces.reshaped()) used[static_cast<std::size_t>(v)] = true;
  std::vector<int> repeated, unused;
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    if (!seen.insert({mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)}).second)
      repeated.push_back(v);
    if (!used[static_cast<std::size_t>(v)]) unused.push_back(v);
  }
  if (!repeated.empty())
    faults.push_back({counted(repeated, "vertex") + " at the place of another one", "each place once",
                      "merge the vertices that coincide"});
  if (!unused.empty())
    faults.push_back(
        {counted(unused, "vertex") + " that no face has", "vertices of faces only", "remove them"});
}

void check_faces(const TriangleMesh& mesh, Faults& faults) {
  // A sliver's height is this much of its longest edge: less is rounding, and the membrane has no metric
  // there.
  constexpr double thinnest = 1e-3;
  std::vector<int> flat, repeated;
  std::set<std::array<int, 3>> seen;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::RowVector3d { return mesh.vertices.row(mesh.faces(f, k % 3)); };
    double longest = 0;
    for (int k = 0; k < 3; ++k) longest = std::max(longest, (corner(k + 1) - corner(k)).norm());
    const double twice_area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    if (!(twice_area > thinnest * longest * longest)) flat.push_back(f);
    std::array<int, 3> corners = {mesh.faces(f, 0), mesh.faces(f, 1), mesh.faces(f, 2)};
    std::ranges::sort(corners);
    if (!seen.insert(corners).second) repeated.push_back(f);
  }
  if (!flat.empty())
    faults.push_back({counted(flat, "face") + " without an area",
                      "triangles thicker than a thousandth of their "
                      "longest edge",
                      "collapse them, or mesh the surface anew"});
  if (!repeated.empty())
    faults.push_back(
        {counted(repeated, "face") + " that stand twice", "each face once", "remove the copies"});
}

/// The faces on either side of each edge, in the direction of each.
struct EdgeSides {
  std::vector<int> along, against;  ///< faces that run from the lower vertex to the higher one, and back
};

using EdgeMap = std::map<std::pair<int, int>, EdgeSides>;

EdgeMap sides_of_edges(const TriangleMesh& mesh) {
  EdgeMap edges;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.faces(f, k), b = mesh.faces(f, (k + 1) % 3);
      EdgeSides& sides = edges[std::minmax(a, b)];
      (a < b ? sides.along : sides.against).push_back(f);
    }
  }
  return edges;
}

std::string counted_edges(const std::vector<std::pair<int, int>>& list) {
  return std::to_string(list.size()) + (list.size() == 1 ? " edge (" : " edges (the first: ") + "vertices " +
         std::to_string(list.front().first) + " and " + std::to_string(list.front().second) + ")";
}

/// True when every edge has two faces that run along it in opposite directions.
bool check_edges(const EdgeMap& edges, Faults& faults) {
  std::vector<std::pair<int, int>> open, crowded, turned;
  for (const auto& [edge, sides] : edges) {
    const std::size_t count = sides.along.size() + sides.against.size();
    if (count == 1) open.push_back(edge);
    if (count > 2) crowded.push_back(edge);
    if (count == 2 && sides.along.size() != 1) turned.push_back(edge);
  }
  if (!open.empty())
    faults.push_back({"a hole: " + counted_edges(open) + " with one face only", "a closed surface",
                      "fill the holes, or merge the vertices that should be one"});
  if (!crowded.empty())
    faults.push_back({counted_edges(crowded) + " with more than two faces", "two faces at every edge",
                      "remove inner walls"});
  if (!turned.empty())
    faults.push_back({counted_edges(turned) + " whose two faces are turned against one another",
                      "all faces counter-clockwise seen from outside", "turn the faces the same way round"});
  return open.empty() && crowded.empty() && turned.empty();
}

/// Number of pieces of the surface, joined by edges.
int count_pieces(const TriangleMesh& mesh, const EdgeMap& edges) {
  std::vector<int> root(static_cast<std::size_t>(mesh.faces.rows()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int f) {
    while (root[static_cast<std::size_t>(f)] != f)
      f = root[static_cast<std::size_t>(f)] =
          root[static_cast<std::size_t>(root[static_cast<std::size_t>(f)])];
    return f;
  };
  int pieces = static_cast<int>(root.size());
  for (const auto& [edge, sides] : edges) {
    int first = -1;
    for (const auto* list : {&sides.along, &sides.against}) {
      for (const int f : *list) {
        if (first < 0) first = f;
        const int a = find(first), b = find(f);
        if (a == b) continue;
        root[static_cast<std::size_t>(a)] = b;
        --pieces;
      }
    }
  }
  return pieces;
}

double enclosed_volume(const TriangleMesh& mesh) {
  const Eigen::RowVector3d origin = mesh.vertices.colwise().mean();
  double volume = 0;
  for (const auto& face : mesh.faces.rowwise()) {
    const Eigen::RowVector3d a = mesh.vertices.row(face(0)) - origin, b = mesh.vertices.row(face(1)) - origin,
                             c = mesh.vertices.row(face(2)) - origin;
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

/// The vertex within `tolerance` of a point, -1 if there is none; `by_x` holds the vertices sorted by x.
int vertex_near(const Eigen::MatrixX3d& vertices, const std::vector<int>& by_x,
                const Eigen::RowVector3d& point, double tolerance) {
  auto v = std::ranges::lower_bound(by_x, point.x() - tolerance, {}, [&](int i) { return vertices(i, 0); });
  for (; v != by_x.end() && vertices(*v, 0) <= point.x() + tolerance; ++v) {
    if ((vertices.row(*v) - point).norm() <= tolerance) return *v;
  }
  return -1;
}

}  // namespace

std::vector<MeshFault> mesh_faults(const TriangleMesh& mesh) {
  Faults faults;
  if (mesh.faces.rows() == 0) return {{"no face", "a closed surface", "give a mesh with faces"}};
  if (!all_finite(mesh, faults)) return faults;
  check_vertices(mesh, faults);
  check_faces(mesh, faults);
  const EdgeMap edges = sides_of_edges(mesh);
  const bool manifold = check_edges(edges, faults);
  const int pieces = count_pieces(mesh, edges);
  if (pieces > 1)
    faults.push_back(
        {std::to_string(pieces) + " pieces that no edge joins", "one piece", "keep one cell in the file"});
  if (!manifold || pieces > 1) return faults;
  const auto euler = mesh.vertices.rows() - static_cast<Eigen::Index>(edges.size()) + mesh.faces.rows();
  if (euler != 2 && faults.empty())
    faults.push_back(
        {"handles, or places where the surface touches itself (V - E + F = " + std::to_string(euler) + ")",
         "a surface like a sphere's (V - E + F = 2)", "close the handles"});
  if (enclosed_volume(mesh) <= 0)
    faults.push_back({"the inside turned out", "faces counter-clockwise seen from outside",
                      "turn all faces: swap two corners of each"});
  return faults;
}

bool make_mirror_symmetric(TriangleMesh& mesh, double tolerance) {
  const int nv = static_cast<int>(mesh.vertices.rows());
  std::vector<int> by_x(static_cast<std::size_t>(nv)), image(static_cast<std::size_t>(nv));
  std::iota(by_x.begin(), by_x.end(), 0);
  std::ranges::sort(by_x, {}, [&](int v) { return mesh.vertices(v, 0); });
  for (int v = 0; v < nv; ++v) {
    Eigen::RowVector3d mirrored = mesh.vertices.row(v);
    mirrored.z() = -mirrored.z();
    image[static_cast<std::size_t>(v)] = vertex_near(mesh.vertices, by_x, mirrored, tolerance);
  }
  for (int v = 0; v < nv; ++v) {
    const int w = image[static_cast<std::size_t>(v)];
    if (w < 0 || image[static_cast<std::size_t>(w)] != v) return false;
  }
  std::set<std::array<int, 3>> faces;
  const auto sorted = [](std::array<int, 3> corners) {
    std::ranges::sort(corners);
    return corners;
  };
  for (const auto& f : mesh.faces.rowwise()) faces.insert(sorted({f(0), f(1), f(2)}));
  const auto image_of = [&](int v) { return image[static_cast<std::size_t>(v)]; };
  for (const auto& f : mesh.faces.rowwise()) {
    if (!faces.contains(sorted({image_of(f(0)), image_of(f(1)), image_of(f(2))}))) return false;
  }
  for (int v = 0; v < nv; ++v) {
    const int w = image_of(v);
    if (w < v) continue;
    const Eigen::RowVector3d a = mesh.vertices.row(v), b = mesh.vertices.row(w);
    const double z = w == v ? 0 : (a.z() - b.z()) / 2;
    mesh.vertices.row(v) << (a.x() + b.x()) / 2, (a.y() + b.y()) / 2, z;
    mesh.vertices.row(w) << mesh.vertices(v, 0), mesh.vertices(v, 1), -z;
  }
  return true;
}

void centre_mesh(TriangleMesh& mesh) {
  const Eigen::RowVector3d centre = mesh.vertices.colwise().mean();
  mesh.vertices.rowwise() -= centre;
}

EdgeLengths edge_lengths(const TriangleMesh& mesh) {
  EdgeLengths lengths;
  const auto edges = edges_of(mesh);
  for (const Edge& edge : edges) {
    const double length = (mesh.vertices.row(edge.v1) - mesh.vertices.row(edge.v2)).norm();
    lengths.mean += length / static_cast<double>(edges.size());
    lengths.longest = std::max(lengths.longest, length);
  }
  return lengths;
}

double radius_in_plane(const TriangleMesh& mesh) {
  return mesh.vertices.leftCols<2>().rowwise().norm().maxCoeff();
}

}  // namespace dld
