/// Controls of the default passage: what half the height leaves out, and where on the lattice the cell
/// starts, must not matter.
#include <gtest/gtest.h>

#include "support/scene_run.hpp"

namespace dld {
namespace {

/// Four pillar lines of a cell in contact with the pillars (d = 6 um, Ca = 0.3).
Case contact_case() {
  return test::case_of(R"({"scene": "passage", "geometry": {"row_shift_um": 6.0}, "stop": {"max_rows": 3},
      "fluid": {"force_density": 1.872e-4}, "cell": {"capillary_number": 0.3}, "output": {"flow_field": false}})");
}

double number(const test::SceneResult& result, const char* name) {
  return result.summary[name].get<double>();
}

void report(const char* what, const test::SceneResult& r) {
  std::printf("%-28s %-10s D_perp %.3f um, centre %.3f um, film %.3f um\n", what, to_string(r.status).c_str(),
              number(r, "d_perp_um"), number(r, "centre_um"), number(r, "film_um"));
}

/// A stiff cell in contact, at nearly twice the force density of the preset. Without a least distance of
/// central linear walls from a node the fluid becomes unstable between membrane and pillar (about step
/// 14,000).
TEST(PassageControl, CentralLinearWallsAreStableBesideAMembrane) {
  const Case c = test::case_of(R"({"scene": "passage", "accuracy": "corrected",
      "geometry": {"row_shift_um": 4.4}, "cell": {"capillary_number": 0.1}, "output": {"flow_field": false},
      "fluid": {"relaxation_time": 1.4, "force_density": 6.7392e-4}, "stop": {"max_steps": 16000}})");
  const test::SceneResult result = test::run_scene(c);
  report("stiff cell in contact", result);
  EXPECT_NE(result.status, Status::diverged);
  EXPECT_LT(number(result, "film_um"), 0.2);  // it was there
}

TEST(PassageControl, SlowFullHeightKeepsTheSymmetricSolution) {
  const test::SceneResult half = test::run_scene(contact_case());
  Case c = contact_case();
  c.geometry.height = "full";
  const test::SceneResult full = test::run_scene(c);
  report("half height", half);
  report("full height", full);
  EXPECT_EQ(full.status, half.status);
  EXPECT_NEAR(number(full, "d_perp_um") / number(half, "d_perp_um"), 1, 1e-3);
  EXPECT_NEAR(number(full, "centre_um"), number(half, "centre_um"), 0.004);
}

/// Half the height forbids a mode that full height has: a tilted cell drifts off the mid plane while it
/// bumps, and stays wider by a few per cent. The bounds state how much that is in this case (measured: 2.2 %
/// in D_perp).
TEST(PassageControl, SlowTiltedStartStaysWiderByAFewPerCent) {
  const test::SceneResult half = test::run_scene(contact_case());
  Case c = contact_case();
  c.geometry.height = "full";
  c.cell.start.z_um = 0.12;  // 0.3 lu off the mid plane
  c.cell.start.tilt_deg = 5;
  const test::SceneResult full = test::run_scene(c);
  report("half height", half);
  report("full height, tilted", full);
  EXPECT_EQ(full.status, half.status);
  const double ratio = number(full, "d_perp_um") / number(half, "d_perp_um");
  EXPECT_GT(ratio, 1.005);
  EXPECT_LT(ratio, 1.04);
  EXPECT_NEAR(number(full, "centre_um"), number(half, "centre_um"), 0.06);
}

TEST(PassageControl, SlowStartShiftedByAFractionOfASpacing) {
  const test::SceneResult reference = test::run_scene(contact_case());
  report("default start", reference);
  for (const double shift : {0.13, 0.27}) {  // um, about 1/3 and 2/3 of dx
    Case c = contact_case();
    c.cell.start.x_um += shift;
    const test::SceneResult shifted = test::run_scene(c);
    report("start moved along x", shifted);
    EXPECT_EQ(shifted.status, reference.status);
    EXPECT_NEAR(number(shifted, "d_perp_um") / number(reference, "d_perp_um"), 1, 0.01);
  }
}

}  // namespace
}  // namespace dld
