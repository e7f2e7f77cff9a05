/// Every guard is provoked: a small case that fails by the quantity that the guard watches, and is stopped
/// with that quantity, its place and a cure.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "parameters/limits.hpp"
#include "scene/monitor.hpp"
#include "support/scene_run.hpp"

namespace dld {
namespace {

/// A cell on a coarse lattice (dx = 0.8 um), about 0.1 ms per step.
Case coarse_case() {
  Case c = test::case_of(R"({"scene": "passage", "geometry": {"row_shift_um": 6.4},
      "fluid": {"lattice_spacing_um": 0.8, "relaxation_time": 1, "force_density": 1e-3}, "cell": {"mesh_frequency": 5}, "coupling": {"steps_per_update": 1},
      "stop": {"when": "rows", "max_rows": 1}, "output": {"flow_field": false}})");
  return c;
}

/// Runs the case and expects it to be stopped by `quantity` before `last_step`.
void expect_stop(const Case& c, const std::string& quantity, long last_step) {
  const test::SceneResult r = test::run_scene(c);
  ASSERT_EQ(r.status, Status::diverged);
  const auto& s = r.summary;
  std::printf("%s\n", s["failing_place"].get<std::string>().c_str());
  EXPECT_EQ(s["failing_quantity"], quantity);
  EXPECT_GT(s["failing_step"].get<long>(), 0);
  EXPECT_LE(s["failing_step"].get<long>(), last_step);
  EXPECT_NE(s["failing_place"].get<std::string>().find(") um"), std::string::npos);
  EXPECT_FALSE(s["advice"].get<std::string>().empty());
  EXPECT_TRUE(s.contains("failing_value") && s.contains("failing_limit"));
}

TEST(Guards, ANaNInTheFluid) {
  Case c = coarse_case();
  c.fluid.collision = "bgk";
  c.fluid.equilibrium = "full";
  c.fluid.relaxation_time = 0.55;
  c.fluid.force_density = 0.5;
  expect_stop(c, "fluid is not a number", 200);
}

TEST(Guards, SpeedOfTheFluid) {
  Case c = coarse_case();
  c.fluid.force_density = 0.01;
  c.cell.local_area_modulus = c.cell.global_area_modulus = 1;
  expect_stop(c, "speed of the fluid", 1000);
}

TEST(Guards, DensityOfTheFluid) {
  Case c = coarse_case();
  c.fluid.relaxation_time = 5;  // slow, under a large pressure
  c.fluid.force_density = 0.02;
  expect_stop(c, "density of the fluid", 200);
}

TEST(Guards, SpeedOfTheMembrane) {
  Case c = coarse_case();
  c.fluid.relaxation_time = 2;
  c.fluid.force_density = 0.01;  // at fixed Ca: a stiff membrane
  expect_stop(c, "speed of the membrane", 200);
}

TEST(Guards, VolumeOfTheCell) {
  Case c = coarse_case();
  c.cell.volume_control = "penalty";
  c.cell.volume_modulus = 0;
  c.cell.mesh_frequency = 3;  // edge = 1.7 dx: fluid leaks between the nodes
  expect_stop(c, "volume of the cell", 10000);
}

TEST(Guards, AreaOfTheCell) {
  Case c = coarse_case();
  c.cell.local_area_modulus = c.cell.global_area_modulus = 0;
  c.cell.capillary_number = 20;
  expect_stop(c, "area of the cell", 2000);
}

TEST(Guards, SmallestFaceOfTheMembrane) {
  Case c = coarse_case();
  c.coupling.regularisation = "none";
  c.cell.mesh_frequency = 12;  // edge = dx / 2.4: the kernel does not see how a face collapses
  c.cell.local_area_modulus = 0;
  c.cell.capillary_number = 20;
  c.cell.bending_ratio = 0;
  expect_stop(c, "smallest face of the membrane", 10000);
}

TEST(Guards, PenetrationOfAPillar) {
  Case c = coarse_case();
  c.coupling.pillar_repulsion = 0;
  c.cell.capillary_number = 1;
  c.cell.start.gap_position_um = 22;  // straight at the next pillar
  expect_stop(c, "penetration of a pillar", 10000);
}

TEST(Guards, ANaNInTheMembraneIsNamedAsOne) {
  Membrane membrane(make_cell("sphere", 2, 3.0), {});
  const Eigen::MatrixX3d x = membrane.reference().vertices;
  Eigen::MatrixX3d v = Eigen::MatrixX3d::Zero(x.rows(), 3);
  v(5, 1) = NAN;
  const CellView view{
      .membrane = membrane, .positions = x, .velocities = v, .state = membrane.measure(x), .speed = HUGE_VAL};
  const auto failure = check_membrane(view);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->quantity, "membrane is not a number");
  EXPECT_EQ(failure->place.find("membrane node 5 at"), 0u);
}

TEST(Guards, LeaveAHealthyRunAlone) {
  const test::SceneResult r = test::run_scene(coarse_case());
  EXPECT_NE(r.status, Status::diverged);
  EXPECT_FALSE(r.summary.contains("failing_quantity"));
  EXPECT_GT(r.summary["smallest_wall_gap_um"].get<double>(), 0);
  EXPECT_EQ(r.summary["crossings"], 2);  // "rows": the first line and one more
}

// The same cases before they are run: `dld check` foresees what the monitors see.
TEST(Guards, TheMarginsForeseeStiffnessAndSpeed) {
  Case c = coarse_case();
  EXPECT_LT(tightest(stability_margins(c))->share, 1);
  c.fluid.force_density = 0.01;
  EXPECT_GT(tightest(stability_margins(c))->share, 1);
}

const Margin& margin(const std::vector<Margin>& margins, const std::string& begin) {
  return *std::ranges::find_if(margins, [&](const Margin& m) { return m.name.starts_with(begin); });
}

/// The case with the bending ratio that uses up this share of its margin.
Case with_bending_share(Case c, double share) {
  c.cell.bending_ratio *= share / margin(stability_margins(c), "bending").share;
  return c;
}

// The limit falls with the viscosity and the resolution: each of these runs within it and fails some way past
// it.
TEST(Guards, TheBendingMarginForeseesAStiffMembrane) {
  Case paper_lattice = coarse_case();
  paper_lattice.fluid.lattice_spacing_um = 0.4;
  paper_lattice.fluid.force_density = 3.744e-4;
  paper_lattice.cell.mesh_frequency = 10;
  paper_lattice.geometry.row_shift_um = 4.8;
  for (const auto& [lattice, past] : {std::pair{coarse_case(), 2.1}, std::pair{paper_lattice, 1.3}}) {
    for (const double tau : {0.8, 1.1, 1.9}) {
      SCOPED_TRACE(testing::Message() << "dx " << lattice.fluid.lattice_spacing_um << " um, tau " << tau);
      Case c = lattice;
      c.fluid.relaxation_time = tau;
      c.stop.max_steps = 2500;  // the flow without the cell takes 1900 of its own
      EXPECT_NE(test::run_scene(with_bending_share(c, 0.9)).status, Status::diverged);
      EXPECT_EQ(test::run_scene(with_bending_share(c, past)).status, Status::diverged);
    }
  }
}

// With BGK a small relaxation time is a small magic parameter; TRT keeps its own and bears it.
TEST(Guards, TheBgkMarginForeseesASmallRelaxationTime) {
  for (const auto& [collision, tau, fails] :
       {std::tuple{"bgk", 0.6, true}, std::tuple{"bgk", 0.9, false}, std::tuple{"trt", 0.6, false}}) {
    SCOPED_TRACE(testing::Message() << collision << ", tau " << tau);
    Case c = coarse_case();
    c.fluid.collision = collision;
    c.fluid.relaxation_time = tau;
    EXPECT_EQ(tightest(stability_margins(c))->share > 1, fails) << tightest(stability_margins(c))->name;
    EXPECT_EQ(test::run_scene(c).status == Status::diverged, fails);
  }
}

TEST(Guards, AFlowWithoutACellIsLabelledToo) {
  for (const std::string scene : {"channel", "streamlines"}) {
    Case c = coarse_case();
    c.scene = scene;
    c.fluid.relaxation_time = 5;
    c.fluid.force_density = 0.5;
    expect_stop(c, "speed of the fluid", 1000);
  }
}

// The walls that repel are those of the box and not those of the device of the case's defaults.
TEST(Guards, RepellingWallsOfAShearedBoxAreFarFromTheCapsule) {
  Case c = test::case_of(R"({"scene": "shear", "fluid": {"lattice_spacing_um": 1},
      "cell": {"shape": "sphere", "radius_um": 6, "mesh_frequency": 6, "local_area_modulus": 1},
      "shear": {"duration": 0.02}})");
  const double without = test::run_scene(c).summary["deformation"];
  c.coupling.wall_repulsion = c.coupling.pillar_repulsion;
  EXPECT_GT(without, 0);
  EXPECT_EQ(test::run_scene(c).summary["deformation"].get<double>(), without);
}

// The presets on the fine lattice keep their force density at every Ca and fail for stiff cells.
TEST(Guards, TheBendingMarginKnowsTheStiffestCellOfAPreset) {
  const auto share = [](const std::string& preset, double ca) {
    const Case c = test::case_of(R"({"scene": "passage", "geometry": {"row_shift_um": 4.8}, "accuracy": ")" +
                                 preset + R"(", "cell": {"capillary_number": )" + std::to_string(ca) + "}}");
    return margin(stability_margins(c), "bending").share;
  };
  EXPECT_GT(share("reference", 0.1), 1);
  EXPECT_LT(share("reference", 0.125), 1);
  EXPECT_GT(share("refined", 0.08), 1);
  EXPECT_LT(share("refined", 0.1), 1);
  for (const std::string preset : {"draft", "standard", "corrected"}) EXPECT_LT(share(preset, 0.1), 1);
}

}  // namespace
}  // namespace dld
