#include "parameters/units.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "parameters/check_text.hpp"
#include "parameters/physical.hpp"
#include "parameters/report.hpp"

namespace dld {
namespace {

// The paper's relaxation time and force density at dx = 0.4 um.
Case paper_case() {
  Case c;
  c.fluid.relaxation_time = 1.0;
  c.fluid.force_density = 9.36e-5;
  return c;
}

TEST(Units, PaperCaseInLatticeUnits) {
  Case c = paper_case();
  c.cell.capillary_number = 1.0;
  const LatticeParameters l = to_lattice(c);
  EXPECT_EQ(l.nx, 80);
  EXPECT_EQ(l.ny, 80);
  EXPECT_EQ(l.nz, 6);
  EXPECT_EQ(l.row_shift, 15);
  EXPECT_TRUE(l.half_height);
  EXPECT_DOUBLE_EQ(l.pillar_radius, 25);
  EXPECT_EQ(l.gap, 30);
  EXPECT_EQ(l.depth, 12);
  EXPECT_NEAR(l.length_scale, 18.974, 5e-4);
  EXPECT_DOUBLE_EQ(l.cell_radius, 9.75);
  EXPECT_NEAR(l.shear_modulus, 1.73154e-2, 5e-7);
  EXPECT_NEAR(l.bending_modulus, 2.481e-3 * l.shear_modulus * 9.75 * 9.75, 1e-12);
  EXPECT_DOUBLE_EQ(l.tau_outside, 1);
  EXPECT_DOUBLE_EQ(l.tau_inside, 3);
}

// The habitual absolute values of this method at the paper's force density.
TEST(Units, DefaultPenalties) {
  const LatticeParameters l = to_lattice(paper_case());
  EXPECT_NEAR(l.local_area_modulus, 0.5, 1e-4);
  EXPECT_NEAR(l.global_area_modulus, 1.0, 1e-4);
  EXPECT_NEAR(l.volume_modulus, 1.0, 1e-4);
  EXPECT_NEAR(l.repulsion_strength, 5e-3, 1e-6);
  EXPECT_EQ(l.wall_repulsion_strength, 0);
}

TEST(Units, FullHeightDoublesTheLayers) {
  Case c;
  c.geometry.height = "full";
  EXPECT_EQ(to_lattice(c).nz, 12);
}

// At fixed dimensionless numbers every modulus follows the force density.
TEST(Units, ModuliScaleWithTheForceDensity) {
  Case c;
  const LatticeParameters once = to_lattice(c);
  c.fluid.force_density *= 2;
  const LatticeParameters twice = to_lattice(c);
  for (const auto member : {&LatticeParameters::shear_modulus, &LatticeParameters::bending_modulus,
                            &LatticeParameters::local_area_modulus, &LatticeParameters::global_area_modulus,
                            &LatticeParameters::volume_modulus, &LatticeParameters::repulsion_strength}) {
    EXPECT_DOUBLE_EQ(twice.*member, 2 * once.*member);
  }
}

// Dimensionless ratios do not depend on the lattice.
TEST(Units, RefinementKeepsDimensionlessNumbers) {
  Case c;
  const LatticeParameters coarse = to_lattice(c);
  c.fluid.lattice_spacing_um /= 2;
  const LatticeParameters fine = to_lattice(c);
  EXPECT_EQ(fine.nx, 2 * coarse.nx);
  EXPECT_EQ(fine.row_shift, 2 * coarse.row_shift);
  const auto capillary = [](const LatticeParameters& l) { return l.tension_scale / l.shear_modulus; };
  EXPECT_NEAR(capillary(fine), capillary(coarse), 1e-12);
  const auto bending = [](const LatticeParameters& l) {
    return l.bending_modulus / (l.shear_modulus * l.cell_radius * l.cell_radius);
  };
  EXPECT_NEAR(bending(fine), bending(coarse), 1e-15);
}

TEST(Units, NearlyWholeNumbersAreRounded) {
  Case c;
  c.fluid.lattice_spacing_um = 0.4 / 3;
  c.geometry.row_shift_um = 4.4;
  const LatticeParameters l = to_lattice(c);
  EXPECT_EQ(l.nx, 240);
  EXPECT_EQ(l.row_shift, 33);
  EXPECT_EQ(l.nz, 18);
}

// p' = Ca kS / (l r): 0.18 bar/m at Ca = 0.1, 2.7 bar/m at Ca = 1.5 for healthy cells in water.
TEST(Units, PressureGradient) {
  Case c;
  c.cell.capillary_number = 0.1;
  EXPECT_NEAR(to_si(c).pressure_gradient_Pa_per_m * 1e-5, 0.179, 1e-3);
  c.cell.capillary_number = 1.5;
  EXPECT_NEAR(to_si(c).pressure_gradient_Pa_per_m * 1e-5, 2.69, 1e-2);
}

TEST(Units, SiScalesAreConsistent) {
  const Case c;
  const LatticeParameters l = to_lattice(c);
  const double eta = 1e-3, dx = 1e-6 * l.um_per_lu;
  const SiScales si = to_si(c, eta);
  EXPECT_NEAR(si.velocity_m_per_s_per_lu * si.time_step_s, dx, 1e-12 * dx);
  // Stokes flow: u = p' / resistance in both systems of units, for any lattice velocity.
  const double u_lu = 1e-3;
  const double resistance = l.force_density / u_lu * si.resistance_Pa_s_per_m2_per_lu;
  EXPECT_NEAR(si.pressure_gradient_Pa_per_m / resistance, u_lu * si.velocity_m_per_s_per_lu,
              1e-12 * u_lu * si.velocity_m_per_s_per_lu);
}

// Scenes without pillars or gap must not divide by zero.
TEST(Units, NoGapGivesNoScales) {
  Case c;
  c.geometry.pillar_radius_um = c.geometry.pitch_um / 2;
  EXPECT_EQ(to_lattice(c).shear_modulus, 0);
  const SiScales si = to_si(c);
  EXPECT_TRUE(std::isfinite(si.velocity_m_per_s_per_lu));
  EXPECT_TRUE(std::isfinite(si.time_step_s));
}

Case case_of_scene(const std::string& scene, const std::string& method = "static") {
  Case c;
  c.scene = scene;
  c.stretching.method = method;
  return c;
}

// The numbers that a scene states are those that it simulates.
TEST(SceneLattice, StretchingAndShearHaveModuliOfTheirOwn) {
  const LatticeParameters still = scene_lattice(case_of_scene("stretching"));
  EXPECT_DOUBLE_EQ(still.shear_modulus, 5.3);  // uN/m
  EXPECT_DOUBLE_EQ(still.local_area_modulus / still.shear_modulus, 28.876);
  const Case coupled = case_of_scene("stretching", "coupled");
  EXPECT_DOUBLE_EQ(scene_lattice(coupled).shear_modulus, coupled_stretching_shear_modulus);
  const Case shear = case_of_scene("shear");
  const LatticeParameters l = scene_lattice(shear);
  EXPECT_NEAR(l.viscosity * l.shear_rate * l.cell_radius / l.shear_modulus, 0.02, 1e-15);
  EXPECT_EQ(l.nx, 80);  // the box of 32 um
  EXPECT_EQ(dimensionless_numbers(case_of_scene("stretching"))["local_area_per_shear_modulus"], 28.876);
  EXPECT_EQ(dimensionless_numbers(shear)["capillary_number"], 0.02);
  EXPECT_EQ(dimensionless_numbers(Case{})["local_area_per_shear_modulus"], 28.876 * 0.5);
}

// Stokes flow: a tension and a velocity fix each other, tension = eta velocity, in both systems of units.
TEST(PhysicalScales, AreConsistent) {
  for (const Case& c : {Case{}, case_of_scene("streamlines"), case_of_scene("shear"),
                        case_of_scene("stretching", "coupled")}) {
    const PhysicalScales s = physical_scales(c);
    const LatticeParameters l = scene_lattice(c);
    EXPECT_NEAR(s.velocity_mm_s * s.time_step_s, 1e-3 * s.um, 1e-12 * s.um) << c.scene;
    EXPECT_NEAR(s.tension_uN_m * l.viscosity, 1e6 * plasma_viscosity_Pa_s * 1e-3 * s.velocity_mm_s,
                1e-9 * s.tension_uN_m * l.viscosity)
        << c.scene;
  }
  const Case passage;
  EXPECT_NEAR(physical_scales(passage).tension_uN_m * to_lattice(passage).shear_modulus, 5.3, 1e-9);
  EXPECT_EQ(physical_scales(case_of_scene("stretching")).time_step_s, 0);
}

TEST(PhysicalScales, OfASummaryStandBesideTheLatticeValues) {
  const nlohmann::ordered_json summary = {{"max_speed", 0.01}, {"speed_um_per_step", nullptr}};
  const auto physical =
      physical_summary(summary, {.um = 0.4, .time_step_s = 1e-6, .velocity_mm_s = 400, .basis = {}});
  EXPECT_DOUBLE_EQ(physical["max_speed_mm_per_s"].get<double>(), 4);
  EXPECT_FALSE(physical.contains("speed_mm_per_s"));
  EXPECT_TRUE(physical_summary(summary, {}).empty());
}

TEST(CheckText, NumbersHaveThreeDigitsAndNoUnitOne) {
  EXPECT_EQ(quantity_text(0.0123456, "lu"), "0.0123 lu");
  EXPECT_EQ(quantity_text(12345, ""), "12300");
  EXPECT_EQ(quantity_text(999.96, ""), "1000");
  EXPECT_EQ(quantity_text(-4567, "um"), "-4570 um");
  EXPECT_EQ(quantity_text(0, ""), "0");
  EXPECT_EQ(quantity_text(1.23456e-6, "s"), "1.23e-06 s");
}

// About ten lines, and those of the scene: a stretching case once stated an area modulus of 14.4 kS
// where 28.9 is used, a shear case Ca 0.5 where 0.02 is used.
TEST(CheckText, StatesTheNumbersOfTheScene) {
  const std::pair<Case, std::vector<std::string>> expected[] = {
      {Case{}, {"gap 12 um", "Ca 0.5", "area modulus 14.4 kS", "80 x 80 x 6", "of what is allowed"}},
      {case_of_scene("stretching"), {"area modulus 28.9 kS", "shear modulus kS 5.3 uN/m", "0 to 200 pN"}},
      {case_of_scene("shear"), {"Ca 0.02", "area modulus 28.9 kS", "80 x 80 x 80"}},
      {case_of_scene("channel"), {"plane channel, depth 4.8 um"}},
      {case_of_scene("streamlines"), {"cell      none", "row shift d = 6 um"}}};
  for (const auto& [c, parts] : expected) {
    const std::string text = check_text(c);
    EXPECT_EQ(std::ranges::count(text, '\n'), 10);
    for (const auto& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

}  // namespace
}  // namespace dld
