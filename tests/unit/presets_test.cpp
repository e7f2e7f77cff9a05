#include "parameters/presets.hpp"

#include <gtest/gtest.h>

#include "parameters/declaration.hpp"
#include "parameters/reader.hpp"
#include "parameters/units.hpp"

namespace dld {
namespace {

Case with_accuracy(const std::string& name, const std::string& rest = "") {
  return parse_case(R"({"scene": "passage", "accuracy": ")" + name + "\"" + rest + "}", "case.json");
}

TEST(Presets, StandardRepeatsTheDefaults) {
  EXPECT_EQ(echo(with_accuracy("standard")), echo(Case{}));
}

TEST(Presets, SetEveryParameterThatTheyName) {
  for (const auto& p : presets()) {
    const auto resolved = echo(with_accuracy(p.name)), settings = p.settings.flatten();
    for (const auto& [pointer, value] : settings.items())
      EXPECT_EQ(resolved.at(nlohmann::ordered_json::json_pointer(pointer)), value) << p.name << pointer;
    EXPECT_EQ(resolved["accuracy"], p.name);
  }
}

// Otherwise a case could keep a setting of one preset when it asks for another.
TEST(Presets, NameTheSameParameters) {
  for (const auto& p : presets()) {
    const auto settings = p.settings.flatten(), standard = preset("standard").settings.flatten();
    ASSERT_EQ(settings.size(), standard.size()) << p.name;
    for (const auto& [pointer, value] : settings.items()) EXPECT_TRUE(standard.contains(pointer)) << pointer;
  }
}

TEST(Presets, GiveWayToExplicitKeys) {
  const Case c = with_accuracy("reference", R"(, "fluid": {"force_density": 1e-5})");
  EXPECT_EQ(c.fluid.force_density, 1e-5);
  EXPECT_EQ(c.fluid.lattice_spacing_um, preset("reference").settings["fluid"]["lattice_spacing_um"]);
  EXPECT_EQ(accuracy_json(c)["departs_in"], nlohmann::ordered_json({"/fluid/force_density"}));
  EXPECT_TRUE(accuracy_json(with_accuracy("reference"))["departs_in"].empty());
}

TEST(Presets, ReadBackFromTheEcho) {
  const auto resolved = echo(with_accuracy("reference", R"(, "cell": {"capillary_number": 0.2})"));
  EXPECT_EQ(echo(parse_case(resolved.dump(), "echo.json")), resolved);
}

TEST(Presets, AnUnknownNameIsAProblemWithAdvice) {
  try {
    with_accuracy("referense");
    FAIL();
  } catch (const CaseError& error) {
    ASSERT_EQ(error.problems.size(), 1u);
    EXPECT_EQ(error.problems[0].pointer, "/accuracy");
    EXPECT_NE(error.problems[0].advice.find("reference"), std::string::npos);
  }
}

TEST(Presets, AreAnnotationsOfTheSchema) {
  const auto annotation = case_schema()["properties"]["accuracy"]["x-presets"];
  ASSERT_EQ(annotation.size(), presets().size());
  for (const auto& p : presets()) EXPECT_EQ(annotation[p.name], p.settings);
}

// Their contact is a length, not a number of lattice spacings.
TEST(Presets, HoldTheContactOfTheCorrectedKernelAtATenthOfAMicrometre) {
  for (const auto* name : {"corrected", "reference"}) {
    const Case c = with_accuracy(name);
    const double range = c.coupling.repulsion_range, standard = CouplingParameters{}.pillar_repulsion;
    EXPECT_NEAR(range * c.fluid.lattice_spacing_um, 0.1, 1e-12) << name;
    EXPECT_NEAR(c.coupling.pillar_repulsion / (range * range), standard, 2e-3 * standard) << name;
    EXPECT_EQ(c.coupling.wall_repulsion, c.coupling.pillar_repulsion) << name;
  }
}

// The finer the lattice of a preset, the later it comes in the list.
TEST(Presets, GoFromCheapToAccurate) {
  double previous = 1e9;
  for (const auto& name : preset_names()) {
    const double dx = with_accuracy(name).fluid.lattice_spacing_um;
    EXPECT_LE(dx, previous) << name;
    previous = dx;
  }
}

}  // namespace
}  // namespace dld
