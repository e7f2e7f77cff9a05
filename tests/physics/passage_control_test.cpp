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
