/// Short passages of cells that are no red cells, on the lattice of the smoke tier: an ellipsoid, the same
/// one as a mesh from a file, and a mesh without a mirror plane in full height.
#include <gtest/gtest.h>

#include "support/mesh_text.hpp"
#include "support/scene_run.hpp"

namespace dld {
namespace {

/// A cell that passes two pillar lines; `cell` and `geometry` are further members of these sections.
std::string passage_text(const std::string& cell, const std::string& geometry = "") {
  return R"({"scene": "passage", "output": {"flow_field": false}, "stop": {"max_rows": 1, "when": "rows"},
      "fluid": {"lattice_spacing_um": 0.8, "force_density": 4.4928e-4},
      "geometry": {"row_shift_um": 6.4)" +
         geometry +
         R"(}, "cell": {"capillary_number": 0.3, "start": {"x_um": -8, "gap_position_um": 3.2}, )" + cell +
         "}}";
}

double number(const test::SceneResult& result, const char* name) {
  return result.summary[name].get<double>();
}

void report(const char* what, const test::SceneResult& r) {
  std::printf("%-22s D_perp %.3f um, centre %.3f um, film %.3f um, area %.2e, volume %.2e, face %.2f\n", what,
              number(r, "d_perp_um"), number(r, "centre_um"), number(r, "smallest_film_um"),
              number(r, "area_change"), number(r, "volume_change"), number(r, "min_face_ratio"));
}

void expect_sound(const test::SceneResult& r) {
  EXPECT_NE(r.status, Status::diverged);
  EXPECT_EQ(r.summary["crossings"], 2);
  EXPECT_LT(number(r, "volume_change"), 1e-3);
  EXPECT_LT(number(r, "area_change"), 0.02);
  EXPECT_GT(number(r, "min_face_ratio"), 0.5);
  EXPECT_GT(number(r, "smallest_film_um"), 0);
}

TEST(CellShapes, AnEllipsoidFromAFileIsTheOneThatIsBuiltIn) {
  const test::SceneResult built =
      test::run_scene(test::case_of(passage_text(R"("shape": "ellipsoid", "semi_axes_um": [4, 3, 1.5],
      "mesh_frequency": 5)")));
  report("ellipsoid", built);
  expect_sound(built);
  // A mesh of an odd frequency has no vertex at the tip of the long axis: its own radius is a little less
  // than r.
  const test::TemporaryFolder folder;
  folder.write("cell.off", test::off_text(ellipsoid(5, {4, 3, 1.5})));
  const test::SceneResult read = test::run_scene(parse_case(
      passage_text(R"("shape": "mesh", "mesh_file": "cell.off", "radius_um": 4)"), folder.case_name()));
  report("ellipsoid from a file", read);
  expect_sound(read);
  EXPECT_NEAR(number(read, "d_perp_um"), number(built, "d_perp_um"), 1e-3);
  EXPECT_NEAR(number(read, "centre_um"), number(built, "centre_um"), 1e-3);
}

/// The inside is found for a shape without any symmetry, and its volume is held.
TEST(CellShapes, AMeshWithoutAMirrorPlanePassesInFullHeight) {
  TriangleMesh pear = ellipsoid(5, {3.5, 2.5, 1.5});
  for (auto v : pear.vertices.rowwise()) v *= 1 + 0.06 * v(0) / 3.5 + 0.04 * v(2) / 1.5;
  const test::TemporaryFolder folder;
  folder.write("pear.stl", test::stl_text(pear));
  const test::SceneResult r = test::run_scene(
      parse_case(passage_text(R"("shape": "mesh", "mesh_file": "pear.stl")", R"(, "height": "full")"),
                 folder.case_name()));
  report("pear, full height", r);
  expect_sound(r);
}

/// Both methods of the tweezer pull at the ends of the ellipsoid and lengthen it.
TEST(CellShapes, AnEllipsoidIsStretched) {
  const auto axial = [](const std::string& method, const std::string& forces) {
    const std::string text =
        R"({"scene": "stretching", "fluid": {"lattice_spacing_um": 0.8}, "stop": {"max_steps": 3000},
        "cell": {"shape": "ellipsoid", "semi_axes_um": [4, 3, 1.5], "mesh_frequency": 4},
        "stretching": {"method": ")" +
        method + R"(", "forces_pN": [)" + forces + "]}}";
    return test::run_scene(test::case_of(text)).summary["axial_um"].back().get<double>();
  };
  const double at_rest = axial("static", "0"), pulled = axial("static", "0, 40");
  std::printf("ellipsoid at rest %.3f um, pulled by 40 pN %.3f um\n", at_rest, pulled);
  EXPECT_NEAR(at_rest, 8, 1e-3);
  EXPECT_GT(pulled, 8.2);
  EXPECT_GT(axial("coupled", "40"), 8.1);
}

}  // namespace
}  // namespace dld
