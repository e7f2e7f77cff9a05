/// SI in, SI out: every drive means a capillary number, and the case says the same conditions again.
#include "parameters/operating.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "parameters/flow_estimate.hpp"
#include "parameters/reader.hpp"
#include "parameters/resolve.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;

Json case_with(const Json& operating) {
  return {{"scene", "passage"}, {"geometry", {{"row_shift_um", 3.2}}}, {"operating", operating}};
}

Reading read(const Json& tree) {
  return read_tree(tree, "");
}

std::vector<Problem> problems_of(const Json& tree) {
  return read(tree).problems;
}

OperatingPoint point_of(const Json& operating) {
  const Reading reading = read(case_with(operating));
  EXPECT_TRUE(reading.problems.empty()) << operating;
  return operating_point(reading.c, expected_mobility_um2(reading.c));
}

TEST(Operating, APressureGradientIsAnExactCapillaryNumber) {
  const Reading reading = read(case_with(
      {{"pressure_gradient_Pa_per_m", 1e5}, {"shear_modulus_uN_per_m", 5}, {"viscosity_mPa_s", 1.2}}));
  ASSERT_TRUE(reading.problems.empty());
  // p' l r / kS with l = sqrt(12 * 4.8) um and r = 3.9 um.
  const double expected = 1e5 * std::sqrt(12 * 4.8) * 1e-6 * 3.9e-6 / 5e-6;
  EXPECT_NEAR(reading.c.cell.capillary_number / expected, 1, 1e-12);
}

// SI -> Ca -> SI, for each way of saying the same conditions.
TEST(Operating, EveryDriveDescribesTheSameCase) {
  const Json material = {{"shear_modulus_uN_per_m", 6.3}, {"viscosity_mPa_s", 1.3}};
  Json gradient = material;
  gradient["pressure_gradient_Pa_per_m"] = 2.5e5;
  const OperatingPoint given = point_of(gradient);
  EXPECT_NEAR(given.pressure_gradient_Pa_per_m / 2.5e5, 1, 1e-12);
  const double length_mm = 7, width_um = 960;
  Json drop = material, speed = material, rate = material;
  drop["pressure_drop_mbar"] = 2.5e5 * length_mm * 1e-3 / 100;
  drop["length_mm"] = length_mm;
  speed["mean_speed_um_per_s"] = given.mean_speed_um_per_s;
  rate["flow_rate_uL_per_min"] = given.flow_rate_uL_per_min_per_um * width_um;
  rate["channel_width_um"] = width_um;
  for (const Json& other : {drop, speed, rate}) {
    const OperatingPoint point = point_of(other);
    EXPECT_NEAR(point.capillary_number / given.capillary_number, 1, 1e-12) << other;
    EXPECT_NEAR(point.pressure_gradient_Pa_per_m / given.pressure_gradient_Pa_per_m, 1, 1e-12) << other;
    EXPECT_NEAR(point.mean_speed_um_per_s / given.mean_speed_um_per_s, 1, 1e-12) << other;
    EXPECT_NEAR(point.flow_rate_uL_per_min_per_um / given.flow_rate_uL_per_min_per_um, 1, 1e-12) << other;
  }
}

// By hand: 1 mbar over 1 mm is 1e5 Pa/m; 12 um * 4.8 um at 1 mm/s.
TEST(Operating, NumbersAreThoseOfAHandCalculation) {
  const OperatingPoint point = point_of({{"pressure_drop_mbar", 1}, {"length_mm", 1}});
  EXPECT_NEAR(point.pressure_gradient_Pa_per_m, 1e5, 1e-6);
  // The paper's device lets 0.6 of the slit's flow through.
  const double slit_speed = 1e5 * 4.8e-6 * 4.8e-6 / 12 / 1e-3;
  EXPECT_NEAR(point.mean_speed_um_per_s / (0.6e6 * slit_speed), 1, 0.06);
  const double open = 1 - std::numbers::pi * 100 / 1024;
  EXPECT_NEAR(point.flow_rate_uL_per_min_per_um / (point.mean_speed_um_per_s * 1e-6 * open * 4.8e-12 * 60e9),
              1, 2e-3);
  EXPECT_NEAR(point.wall_shear_rate_per_s, 6 * point.mean_speed_um_per_s / 4.8, 1e-9);
  EXPECT_NEAR(point.time_per_row_ms, 32e3 / point.mean_speed_um_per_s, 1e-9);
}

TEST(Operating, WhatIsWrongIsNamed) {
  const auto pointer = [](const Json& operating) {
    const auto found = problems_of(case_with(operating));
    return found.empty() ? "" : found.front().pointer;
  };
  EXPECT_EQ(pointer({{"pressure_drop_mbar", 1}}), "/operating/pressure_drop_mbar");
  EXPECT_EQ(pointer({{"length_mm", 1}}), "/operating/length_mm");
  EXPECT_EQ(pointer({{"flow_rate_uL_per_min", 1}}), "/operating/flow_rate_uL_per_min");
  EXPECT_EQ(pointer({{"mean_speed_um_per_s", 1}, {"pressure_gradient_Pa_per_m", 1}}), "/operating");
  EXPECT_EQ(pointer({{"mean_speed_um_per_s", -1}}), "/operating/mean_speed_um_per_s");
  EXPECT_EQ(pointer({{"mean_speed_mm_per_s", 1}}), "/operating/mean_speed_mm_per_s");
  EXPECT_EQ(pointer({{"pressure_gradient_Pa_per_m", 1e12}}), "/operating/pressure_gradient_Pa_per_m");
  EXPECT_EQ(pointer({{"viscosity_mPa_s", 2}}), "");  // SI numbers of a case that gives Ca
  Json both = case_with({{"mean_speed_um_per_s", 100}});
  both["cell"]["capillary_number"] = 0.5;
  ASSERT_EQ(problems_of(both).size(), 1u);
  EXPECT_EQ(problems_of(both).front().pointer, "/cell/capillary_number");
  Json other = case_with({{"mean_speed_um_per_s", 100}});
  other["scene"] = "stretching";
  EXPECT_EQ(problems_of(other).front().pointer, "/operating/mean_speed_um_per_s");
}

// Each of these changes the flow of the device, so that one remembered for another would be wrong.
TEST(Operating, EveryDeviceHasItsOwnResistance) {
  const auto mobility = [](const Json& more) {
    Json tree = {{"scene", "passage"}, {"geometry", {{"row_shift_um", 3.2}}}};
    tree["geometry"].update(more);
    const Reading reading = read(tree);
    EXPECT_TRUE(reading.problems.empty()) << tree;
    return device_mobility_um2(reading.c);
  };
  const Mobility circle = mobility(Json::object());
  const Json same = {{"pillar", {{"shape", "circle"}, {"radius_um", 10}}}};
  EXPECT_EQ(mobility(same).xx, circle.xx);
  for (const Json& other : {Json{{"pillar", {{"shape", "circle"}, {"radius_um", 8}}}},
                            Json{{"pillar", {{"shape", "ellipse"}, {"semi_axes_um", {10, 8}}}}},
                            Json{{"pitch_y_um", 40}}, Json{{"layout", "rotated_square"}}}) {
    EXPECT_GT(std::abs(mobility(other).xx / circle.xx - 1), 1e-3) << other;
  }
  EXPECT_NEAR(mobility({{"pitch_y_um", 40}}).open_area, 1 - std::numbers::pi * 100 / (32 * 40), 1e-12);
}

// Pillars at the corners of squares let as much through along every direction and push nothing aside.
TEST(Operating, ARotatedSquareArrayHasNoLateralFlow) {
  const Json tree = {{"scene", "passage"}, {"geometry", {{"epsilon", 0.2}, {"layout", "rotated_square"}}}};
  const Reading reading = read(tree);
  ASSERT_TRUE(reading.problems.empty());
  const Mobility& m = device_mobility_um2(reading.c);
  EXPECT_NEAR(m.lateral_ratio(), 0, 1e-6);
  EXPECT_NEAR(m.yy / m.xx, 1, 1e-6);
}

// What runs, and what its identity is made from, is the capillary number.
TEST(Operating, TheResolvedCaseHasTheCapillaryNumberAndNoMore) {
  const Json answer = resolved_json(case_with({{"mean_speed_um_per_s", 800}}), "");
  EXPECT_FALSE(answer["case"].contains("operating"));
  const double number = answer["case"]["cell"]["capillary_number"];
  EXPECT_EQ(number, answer["operating"]["capillary_number"]);
  EXPECT_NEAR(answer["operating"]["mean_speed_um_per_s"].get<double>(), 800, 1e-9);
  Json again = answer["case"];
  again.erase("operating");
  EXPECT_EQ(read(again).c.cell.capillary_number, number);
}

TEST(Operating, ACaseWithoutTheSectionStaysAsItWas) {
  EXPECT_FALSE(operating_given(Case{}));
  const auto schema = case_schema()["properties"]["operating"];
  for (const auto& [name, property] : schema["properties"].items()) {
    EXPECT_FALSE(property.contains("default")) << name;
  }
}

}  // namespace
}  // namespace dld
