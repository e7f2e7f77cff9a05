/// Cells with a size of their own in a case: what is read, completed and refused.
#include "parameters/cell_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "membrane/mesh_check.hpp"
#include "parameters/limits.hpp"
#include "parameters/reader.hpp"
#include "parameters/units.hpp"
#include "support/mesh_text.hpp"

namespace dld {
namespace {

class MeshCell : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;

  /// A case with the mesh as its cell; `more` are further members of the case.
  std::string text(const TriangleMesh& mesh, const std::string& more = "",
                   const std::string& scene = "passage") {
    folder.write("cell.off", test::off_text(mesh));
    return R"({"scene": ")" + scene + R"(", "cell": {"shape": "mesh", "mesh_file": "cell.off"})" + more + "}";
  }
  Case read(const std::string& text) const { return parse_case(text, folder.case_name()); }
  std::vector<Problem> problems(const std::string& text) const {
    try {
      read(text);
      return {};
    } catch (const CaseError& error) {
      return error.problems;
    }
  }
};

/// Whether one of the problems has this pointer and this part of a text in value or allowed.
bool has(const std::vector<Problem>& problems, const std::string& pointer, const std::string& part) {
  return std::ranges::any_of(problems, [&](const Problem& p) {
    return p.pointer == pointer && (p.value + "|" + p.allowed).find(part) != std::string::npos;
  });
}

TEST_F(MeshCell, SphereFromAFileIsTheSphereThatIsBuiltIn) {
  const TriangleMesh built = sphere(6, 2.3);
  const Case c = read(text(built));
  EXPECT_NEAR(c.cell.radius_um, 2.3, 1e-12);
  const double radius = to_lattice(c).cell_radius;
  const TriangleMesh mesh = cell_mesh(c.cell, radius);
  EXPECT_EQ(mesh.faces, built.faces);
  EXPECT_LT((mesh.vertices - sphere(6, radius).vertices).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_NO_THROW(mirror_images(mesh.vertices));
  EXPECT_TRUE(mirror_symmetric(c.cell));
}

TEST_F(MeshCell, IsMovedToItsCentreAndKeepsItsSize) {
  TriangleMesh mesh = red_blood_cell(10, 3.9);
  mesh.vertices.rowwise() += Eigen::RowVector3d(20, -7, 100);
  const Case c = read(text(mesh));
  EXPECT_LT(c.cell.surface->mesh_um.vertices.colwise().mean().norm(), 1e-12);
  EXPECT_NEAR(in_plane_radius_um(c.cell), 3.9, 1e-9);
  EXPECT_TRUE(mirror_symmetric(c.cell));
}

TEST_F(MeshCell, RadiusIsTheScaleOfTheModuliOnly) {
  const TriangleMesh mesh = sphere(6, 2.0);
  const Case c = read(text(mesh));
  std::string given = text(mesh);
  given.replace(given.find("\"shape\""), 7, "\"radius_um\": 3, \"shape\"");
  const Case scaled = read(given);
  EXPECT_DOUBLE_EQ(to_lattice(scaled).tension_scale / to_lattice(c).tension_scale, 1.5);
  EXPECT_LT((cell_mesh(scaled.cell, to_lattice(scaled).cell_radius).vertices -
             cell_mesh(c.cell, to_lattice(c).cell_radius).vertices)
                .norm(),
            1e-12);
  EXPECT_EQ(echo(read(echo(c).dump())), echo(c));
}

TEST_F(MeshCell, AllFaultsOfMeshAndCaseAreSaidAtOnce) {
  TriangleMesh mesh = sphere(6, 2.0);
  mesh.faces.conservativeResize(mesh.faces.rows() - 1, 3);
  std::swap(mesh.faces(7, 0), mesh.faces(7, 1));
  const auto found = problems(text(mesh, R"(, "fluid": {"walls": "none"})"));
  EXPECT_TRUE(has(found, "/cell/mesh_file", "a hole"));
  EXPECT_TRUE(has(found, "/cell/mesh_file", "turned against one another"));
  EXPECT_TRUE(has(found, "/fluid/walls", "half_way"));
}

TEST_F(MeshCell, IsRefusedWhereItDoesNotFit) {
  EXPECT_TRUE(has(problems(text(sphere(8, 2.5))), "/cell/mesh_file", "depth of 4.8"));
  EXPECT_TRUE(has(problems(text(ellipsoid(10, {6.5, 6.2, 1.0}))), "/cell/mesh_file", "gap of 12"));
  EXPECT_TRUE(has(problems(text(sphere(2, 2.0))), "/cell/mesh_file", "mean edge"));
  EXPECT_TRUE(has(problems(text(sphere(14, 2.0))), "/cell/mesh_file", "mean edge"));
  EXPECT_TRUE(has(problems(text(ellipsoid(6, {5.5, 1.3, 1.3}))), "/cell/mesh_file", "an edge of"));
  EXPECT_TRUE(problems(text(ellipsoid(10, {5.0, 3.0, 1.5}))).empty());
  const std::string box = R"(, "shear": {"box_um": 8})";
  EXPECT_TRUE(has(problems(text(sphere(8, 4.2), box, "shear")), "/cell/mesh_file", "half the box"));
  const std::string tip = R"(, "stretching": {"contact_radius_um": 2.5})";
  EXPECT_TRUE(has(problems(text(sphere(6, 2.0), tip, "stretching")), "/stretching/contact_radius_um", "tip"));
}

TEST_F(MeshCell, HalfTheHeightNeedsAMirrorImage) {
  TriangleMesh pear = sphere(6, 2.0);
  for (auto v : pear.vertices.rowwise()) v(2) *= v(2) > 0 ? 1.05 : 0.9;
  EXPECT_TRUE(has(problems(text(pear)), "/cell/mesh_file", "mirror images"));
  EXPECT_TRUE(problems(text(pear, R"(, "geometry": {"height": "full"})")).empty());
  const std::string coupled = R"(, "stretching": {"method": "coupled"})";
  EXPECT_TRUE(has(problems(text(pear, coupled, "stretching")), "/cell/mesh_file", "mirror images"));
}

TEST_F(MeshCell, StartsAtAHeightThatHoldsAllOfIt) {
  TriangleMesh pear = sphere(6, 1.5);
  for (auto v : pear.vertices.rowwise()) v(2) *= v(2) > 0 ? 1.4 : 0.8;
  const auto at = [&](double z_um) {
    std::string c = text(pear, R"(, "geometry": {"height": "full"})");
    return problems(
        c.replace(c.find("\"shape\""), 7, "\"start\": {\"z_um\": " + std::to_string(z_um) + "}, \"shape\""));
  };
  EXPECT_TRUE(at(-0.9).empty());
  EXPECT_FALSE(at(0.9).empty());
}

TEST_F(MeshCell, AMarginOfTheMeshGoesWithItsOwnEdges) {
  const auto edge = [](const Case& c) {
    for (const Margin& m : stability_margins(c)) {
      if (m.name == "mesh edge / dx") return m.value;
    }
    return 0.0;
  };
  EXPECT_NEAR(edge(read(text(sphere(5, 2.0)))), edge_lengths(sphere(5, 5.0)).mean, 1e-12);
}

TEST(EllipsoidCell, IsCompletedFromItsAxes) {
  const Case c = parse_case(
      R"({"scene": "passage", "cell": {"shape": "ellipsoid", "semi_axes_um": [2, 5, 1.5]}})", "case.json");
  EXPECT_EQ(c.cell.radius_um, 5);
  EXPECT_EQ(in_plane_radius_um(c.cell), 5);
  const TriangleMesh mesh = cell_mesh(c.cell, to_lattice(c).cell_radius);
  EXPECT_NEAR(mesh.vertices.col(0).maxCoeff(), 5, 1e-12);
  EXPECT_NEAR(mesh.vertices.col(1).maxCoeff(), 12.5, 1e-12);
  EXPECT_EQ(echo(parse_case(echo(c).dump(), "echo.json")), echo(c));
}

TEST(EllipsoidCell, NeedsThreeAxes) {
  for (const char* axes : {"", R"(, "semi_axes_um": [2, 5])", R"(, "semi_axes_um": [2, 5, 0])"}) {
    try {
      parse_case(std::string(R"({"scene": "passage", "cell": {"shape": "ellipsoid")") + axes + "}}",
                 "case.json");
      FAIL() << axes;
    } catch (const CaseError& error) {
      ASSERT_EQ(error.problems.size(), 1u) << axes;
      EXPECT_EQ(error.problems[0].pointer, "/cell/semi_axes_um");
    }
  }
}

/// Absent keys stay absent: the names of runs that were made before do not change.
TEST(OptionalKeys, AreNeitherEchoedNorGivenADefault) {
  const auto cell = echo(Case{})["cell"];
  const auto schema = case_schema()["properties"]["cell"]["properties"];
  for (const char* name : {"semi_axes_um", "mesh_file"}) {
    EXPECT_FALSE(cell.contains(name));
    ASSERT_TRUE(schema.contains(name));
    EXPECT_FALSE(schema[name].contains("default"));
  }
}

}  // namespace
}  // namespace dld
