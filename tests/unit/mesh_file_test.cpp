/// Meshes from files: what is read is what was written, and what is no cell is said so.
#include "membrane/mesh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "membrane/membrane.hpp"
#include "membrane/mesh_check.hpp"
#include "support/mesh_text.hpp"

namespace dld {
namespace {

/// Words of the error with which a file is refused; empty if it is read.
std::string refusal(const std::filesystem::path& path) {
  try {
    read_mesh(path);
    return "";
  } catch (const MeshFileError& error) {
    return error.what();
  }
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(MeshFile, OffGivesBackTheMeshToTheLastBit) {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = sphere(4, 3.9);
  const TriangleMesh read = read_mesh(folder.write("sphere.off", test::off_text(mesh)));
  EXPECT_EQ(read.vertices, mesh.vertices);
  EXPECT_EQ(read.faces, mesh.faces);
}

TEST(MeshFile, StlJoinsTheCornersOfItsFaces) {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = red_blood_cell(4, 3.9);
  for (const auto& path :
       {folder.write("text.stl", test::stl_text(mesh)), folder.write("bytes.STL", test::stl_bytes(mesh))}) {
    const TriangleMesh read = read_mesh(path);
    ASSERT_EQ(read.vertices.rows(), mesh.vertices.rows()) << path;
    ASSERT_EQ(read.faces.rows(), mesh.faces.rows()) << path;
    EXPECT_TRUE(mesh_faults(read).empty());
    for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const Eigen::RowVector3d difference =
            read.vertices.row(read.faces(f, k)) - mesh.vertices.row(mesh.faces(f, k));
        EXPECT_LT(difference.norm(), 1e-6);
      }
    }
  }
}

TEST(MeshFile, SaysWhereAFileIsNoMesh) {
  const test::TemporaryFolder folder;
  const auto off = [&](const std::string& text) { return refusal(folder.write("mesh.off", text)); };
  EXPECT_TRUE(contains(off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"), "line 5: no number: x"));
  EXPECT_TRUE(
      contains(off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 0\n"), "line 6: a face has three corners"));
  EXPECT_TRUE(contains(off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6: no vertex 3"));
  EXPECT_TRUE(contains(off("OFF\n3 1 0\n0 0 0\n1 0 0\n"), "the file ends where vertex 2"));
  EXPECT_TRUE(contains(off("OFF\n1 0 0\n0 0 0\n7\n"), "more lines"));
  EXPECT_TRUE(contains(off("OFF\n99999999999 1 0\n"), "more than a million"));
  EXPECT_TRUE(contains(off("STL\n"), "begins with the word OFF"));
  EXPECT_TRUE(contains(off(""), "the file ends"));
  EXPECT_TRUE(contains(refusal(folder.write("short.stl", std::string(90, ' '))), "number of facets"));
  EXPECT_TRUE(
      contains(refusal(folder.write("a.stl", "solid\nfacet\nvertex 0 0 0\nendfacet\n")), "three vertices"));
  EXPECT_TRUE(contains(refusal(folder.write("mesh.obj", "v 0 0 0\n")), ".off"));
  EXPECT_TRUE(contains(refusal("no/such/mesh.off"), "cannot be read"));
  EXPECT_EQ(off("OFF 4 4 6\n0 0 0 # origin\n1 0 0\n0 1 0\n0 0 1\n\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3 0.5\n"),
            "");
}

struct Broken {
  const char* name;
  std::function<void(TriangleMesh&)> damage;
  std::vector<std::string> found;  ///< parts of the faults, one each
};

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto nv = mesh.vertices.rows(), nf = mesh.faces.rows();
  mesh.vertices.conservativeResize(nv + other.vertices.rows(), 3);
  mesh.vertices.bottomRows(other.vertices.rows()) = other.vertices;
  mesh.faces.conservativeResize(nf + other.faces.rows(), 3);
  mesh.faces.bottomRows(other.faces.rows()) = other.faces.array() + static_cast<int>(nv);
}

/// Gives face 0 a vertex of its own at the place of its first one.
void split_vertex(TriangleMesh& mesh) {
  mesh.vertices.conservativeResize(mesh.vertices.rows() + 1, 3);
  mesh.vertices.bottomRows(1) = mesh.vertices.row(mesh.faces(0, 0));
  mesh.faces(0, 0) = static_cast<int>(mesh.vertices.rows()) - 1;
}

std::vector<Broken> broken_meshes() {
  return {
      {"hole",
       [](TriangleMesh& m) { m.faces.conservativeResize(m.faces.rows() - 1, 3); },
       {"a hole: 3 edges"}},
      {"flipped face",
       [](TriangleMesh& m) { std::swap(m.faces(7, 0), m.faces(7, 1)); },
       {"3 edges (the first: vertices"}},
      {"inside out", [](TriangleMesh& m) { m.faces.col(0).swap(m.faces.col(1)); }, {"the inside turned out"}},
      {"two pieces",
       [](TriangleMesh& m) {
         TriangleMesh other = sphere(2, 1.0);
         other.vertices.col(0).array() += 9;
         append(m, other);
       },
       {"2 pieces"}},
      {"a vertex twice", split_vertex, {"1 vertex (162) at the place of another one", "a hole: 4 edges"}},
      {"an idle vertex",
       [](TriangleMesh& m) {
         m.vertices.conservativeResize(m.vertices.rows() + 1, 3);
         m.vertices.bottomRows(1) << 9, 9, 9;
       },
       {"1 vertex (162) that no face has"}},
      {"a face twice",
       [](TriangleMesh& m) {
         m.faces.conservativeResize(m.faces.rows() + 1, 3);
         m.faces.bottomRows(1) = m.faces.row(0);
       },
       {"1 face (320) that stand twice", "with more than two faces"}},
      {"a flat face",
       [](TriangleMesh& m) { m.vertices.row(m.faces(0, 0)) = m.vertices.row(m.faces(0, 1)); },
       {"at the place of another one", "without an area"}},
      {"not a number", [](TriangleMesh& m) { m.vertices(3, 1) = NAN; }, {"1 vertex (3) without finite"}},
      {"empty", [](TriangleMesh& m) { m.faces.resize(0, 3); }, {"no face"}},
      {"hole and flipped face",
       [](TriangleMesh& m) {
         m.faces.conservativeResize(m.faces.rows() - 1, 3);
         std::swap(m.faces(7, 0), m.faces(7, 1));
       },
       {"a hole: 3 edges", "turned against one another"}},
  };
}

TEST(MeshCheck, FindsEveryFault) {
  EXPECT_TRUE(mesh_faults(sphere(4, 2.0)).empty());
  EXPECT_TRUE(mesh_faults(red_blood_cell(5, 2.0)).empty());
  for (const Broken& broken : broken_meshes()) {
    TriangleMesh mesh = sphere(4, 2.0);
    broken.damage(mesh);
    const auto faults = mesh_faults(mesh);
    for (const std::string& part : broken.found) {
      EXPECT_TRUE(std::ranges::any_of(faults, [&](const MeshFault& f) { return contains(f.found, part); }))
          << broken.name << ": " << part << ", found " << (faults.empty() ? "nothing" : faults.front().found);
    }
    for (const MeshFault& fault : faults) EXPECT_FALSE(fault.advice.empty() || fault.allowed.empty());
  }
}

/// A ring of a square section: closed, oriented, one piece, and no cell.
TEST(MeshCheck, FindsAHandle) {
  constexpr int n = 8;
  TriangleMesh ring;
  ring.vertices.resize(4 * n, 3);
  ring.faces.resize(8 * n, 3);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    for (int k = 0; k < 4; ++k) {
      const double radius = k == 0 || k == 3 ? 2 : 1, z = k < 2 ? -0.5 : 0.5;
      ring.vertices.row(4 * i + k) << radius * std::cos(angle), radius * std::sin(angle), z;
      const int a = 4 * i + k, b = 4 * i + (k + 1) % 4, c = 4 * ((i + 1) % n) + k,
                d = 4 * ((i + 1) % n) + (k + 1) % 4;
      ring.faces.row(8 * i + 2 * k) << a, b, c;
      ring.faces.row(8 * i + 2 * k + 1) << c, b, d;
    }
  }
  const auto faults = mesh_faults(ring);
  ASSERT_FALSE(faults.empty());
  EXPECT_TRUE(contains(faults.front().found, "handles")) << faults.front().found;
}

TEST(MeshCheck, MirrorSymmetryIsMadeExactWhereItIsThere) {
  TriangleMesh mesh = red_blood_cell(5, 3.0);
  const TriangleMesh exact = mesh;
  for (Eigen::Index i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices(i) += 1e-7 * std::sin(12.9898 * static_cast<double>(i));  // as a file with few digits does
  EXPECT_THROW(mirror_images(mesh.vertices), std::invalid_argument);
  EXPECT_TRUE(make_mirror_symmetric(mesh, 1e-5));
  EXPECT_NO_THROW(mirror_images(mesh.vertices));
  EXPECT_LT((mesh.vertices - exact.vertices).cwiseAbs().maxCoeff(), 2e-7);
  TriangleMesh pear = exact;
  for (auto v : pear.vertices.rowwise()) v(2) *= v(2) > 0 ? 1.1 : 1;
  const TriangleMesh before = pear;
  EXPECT_FALSE(make_mirror_symmetric(pear, 1e-5));
  EXPECT_EQ(pear.vertices, before.vertices);
}

/// Vertices that are symmetric do not suffice: a diagonal of two faces can lie the other way below.
TEST(MeshCheck, MirrorSymmetryHoldsForFacesToo) {
  TriangleMesh mesh = sphere(4, 3.0);
  for (const Edge& e : edges_of(mesh)) {
    const auto z = [&](int v) { return mesh.vertices(v, 2); };
    if (std::min({z(e.v1), z(e.v2), z(e.v3), z(e.v4)}) <= 0) continue;
    mesh.faces.row(e.face) << e.v3, e.v4, e.v2;
    mesh.faces.row(e.opposite_face) << e.v4, e.v3, e.v1;
    break;
  }
  EXPECT_TRUE(mesh_faults(mesh).empty());
  EXPECT_NO_THROW(mirror_images(mesh.vertices));
  EXPECT_FALSE(make_mirror_symmetric(mesh, 1e-5));
}

/// Volume 4/3 pi abc; area of a spheroid with semi-axes a, a, c < a (Beyer, CRC Handbook of Mathematical
/// Sciences): 2 pi a^2 (1 + (1 - e^2)/e artanh e), e^2 = 1 - c^2/a^2.
TEST(Ellipsoid, HasItsAreaAndVolumeAtSecondOrder) {
  const double a = 3, c = 1.5, e = std::sqrt(1 - c * c / (a * a));
  const double area = 2 * std::numbers::pi * a * a * (1 + (1 - e * e) / e * std::atanh(e));
  const double volume = 4.0 / 3 * std::numbers::pi * a * a * c;
  double area_error = 0, volume_error = 0, coarse_area = 0, coarse_volume = 0;
  for (int n : {16, 32}) {
    coarse_area = area_error;
    coarse_volume = volume_error;
    const Membrane membrane(ellipsoid(n, {a, a, c}), {});
    area_error = area - membrane.reference_area();
    volume_error = volume - membrane.reference_volume();
  }
  EXPECT_NEAR(std::log2(coarse_area / area_error), 2, 0.1);
  EXPECT_NEAR(std::log2(coarse_volume / volume_error), 2, 0.1);
  EXPECT_LT(area_error / area, 1.5e-3);
  const Membrane triaxial(ellipsoid(32, {4, 2.5, 1.5}), {});
  EXPECT_NEAR(triaxial.reference_volume() / (4.0 / 3 * std::numbers::pi * 4 * 2.5 * 1.5), 1, 3e-3);
  EXPECT_NO_THROW(mirror_images(ellipsoid(5, {4, 2.5, 1.5}).vertices));
}

}  // namespace
}  // namespace dld
