/// What the reader says besides yes and no: keys without effect, advice, places in the file.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "parameters/declaration.hpp"
#include "parameters/effect.hpp"
#include "parameters/headline.hpp"
#include "parameters/reader.hpp"
#include "parameters/syntax.hpp"
#include "support/scene_run.hpp"

namespace dld {
namespace {

std::vector<Problem> problems_of(const std::string& text) {
  try {
    parse_case(text, "case.json");
    return {};
  } catch (const CaseError& error) {
    return error.problems;
  }
}

/// The one problem of a case.
Problem problem_of(const std::string& text) {
  const auto problems = problems_of(text);
  EXPECT_EQ(problems.size(), 1u) << text;
  return problems.empty() ? Problem{} : problems.front();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct Unused {
  const char *text, *key, *instead;
};

TEST(Effect, AKeyThatChangesNothingIsSaidWithTheOneThatWould) {
  for (const auto& [text, key, instead] : std::vector<Unused>{
           {R"({"scene": "shear", "cell": {"capillary_number": 0.5, "radius_um": 3}})",
            "/cell/capillary_number", "/shear/capillary_number"},
           {R"({"scene": "stretching", "cell": {"capillary_number": 0.5}})", "/cell/capillary_number",
            "/stretching/shear_modulus_uN_per_m"},
           {R"({"scene": "passage", "stretching": {"shear_modulus_uN_per_m": 5}})",
            "/stretching/shear_modulus_uN_per_m", "/cell/capillary_number"},
           {R"({"scene": "passage", "channel": {"width_um": 5}})", "/channel/width_um", "/geometry/pitch_um"},
           {R"({"scene": "passage", "cell": {"volume_modulus": 100}})", "/cell/volume_modulus",
            "/cell/volume_control is penalty"},
           {R"({"scene": "passage", "fluid": {"collision": "bgk", "magic_parameter": 0.25}})",
            "/fluid/magic_parameter", "/fluid/collision is trt"},
           {R"({"scene": "streamlines", "stop": {"max_rows": 5}})", "/stop/max_rows", "/stop/max_steps"},
           {R"({"scene": "passage", "cell": {"semi_axes_um": [1, 2, 3]}})", "/cell/semi_axes_um",
            "ellipsoid"},
           {R"({"scene": "channel", "cell": {"radius_um": 3}})", "/cell/radius_um", "does not read it"}}) {
    const Case c = parse_case(text, "case.json");
    ASSERT_EQ(c.warnings.size(), 1u) << text;
    EXPECT_TRUE(contains(c.warnings[0], key) && contains(c.warnings[0], instead)) << c.warnings[0];
  }
}

TEST(Effect, NothingIsSaidOfWhatIsRead) {
  EXPECT_TRUE(
      parse_case(R"({"scene": "passage", "cell": {"capillary_number": 0.5, "start": {"x_um": -16}}})", "c")
          .warnings.empty());
  EXPECT_TRUE(
      parse_case(R"({"scene": "passage", "$schema": "x", "description": "a cell"})", "c").warnings.empty());
  EXPECT_TRUE(
      parse_case(R"({"scene": "stretching", "cell": {"volume_modulus": 9, "volume_control": "projection"}})",
                 "c")
          .warnings.size() == 1);
}

/// A case that was resolved gives every key, by no choice of its author.
TEST(Effect, NothingIsSaidOfAResolvedCase) {
  for (const char* scene : {"passage", "streamlines", "stretching", "channel", "shear"}) {
    const Case c =
        parse_case(std::string(R"({"scene": ")") + scene + R"(", "cell": {"radius_um": 3.0}})", "c");
    EXPECT_TRUE(parse_case(echo(c).dump(), "echo").warnings.empty()) << scene;
  }
}

/// A section that the table does not know would have an effect everywhere, and nothing would be said of its
/// keys.
TEST(Effect, EverySectionHasItsReaders) {
  std::vector<std::string> all = sections();
  all.emplace_back("operating");
  for (const std::string& section : all) {
    bool without = false;
    for (const char* scene : {"passage", "streamlines", "stretching", "channel", "shear"}) {
      Case c;
      c.scene = scene;
      without = without || without_effect("/" + section + "/another_key", c).has_value();
    }
    EXPECT_TRUE(without) << section;
  }
}

/// Another value of the field, within what is allowed where that is an interval.
struct Change {
  const Allowed& allowed;
  void operator()(double* x) const { *x = *x == 0 ? 0.5 : 0.9 * *x; }
  void operator()(int* x) const { *x = *x + 1; }
  void operator()(long* x) const { *x = *x + 1; }
  void operator()(bool* x) const { *x = !*x; }
  void operator()(std::vector<double>* x) const { x->push_back(1); }
  void operator()(std::optional<double>* x) const { *x = 0.9 * x->value_or(32); }
  void operator()(std::optional<std::string>* x) const { *x = allowed.names.front(); }
  void operator()(std::optional<PillarValues>* x) const { *x = PillarValues{"circle", {{"radius_um", {7}}}}; }
  void operator()(std::string* x) const {
    for (const std::string& name : allowed.names) {
      if (name == *x) continue;
      *x = name;
      return;
    }
  }
};

/// The table is true: all keys that are said to have no effect are changed at once, and the result is the
/// same.
TEST(Effect, KeysWithoutEffectChangeNothing) {
  for (
      const char* text :
      {R"({"scene": "streamlines", "fluid": {"lattice_spacing_um": 1.6, "collision": "bgk"},
            "geometry": {"row_shift_um": 6.4, "depth_um": 6.4}, "stop": {"max_steps": 400}})",
       R"({"scene": "channel", "fluid": {"lattice_spacing_um": 0.8}, "stop": {"max_steps": 400}})",
       R"({"scene": "stretching", "cell": {"mesh_frequency": 4}, "stretching": {"forces_pN": [20]}})",
       R"({"scene": "stretching", "cell": {"mesh_frequency": 4, "viscosity_ratio": 1}, "stop": {"max_steps": 1000},
            "fluid": {"lattice_spacing_um": 0.8}, "stretching": {"forces_pN": [20], "method": "coupled"}})",
       R"({"scene": "shear", "cell": {"mesh_frequency": 4, "radius_um": 3, "viscosity_ratio": 1},
            "fluid": {"lattice_spacing_um": 0.8}, "shear": {"box_um": 12.8, "duration": 0.02}})",
       R"({"scene": "passage", "cell": {"mesh_frequency": 5, "viscosity_ratio": 1}, "stop": {"max_steps": 600},
            "coupling": {"regularisation": "none"}, "fluid": {"lattice_spacing_um": 0.8, "collision": "bgk"},
            "geometry": {"row_shift_um": 6.4}})"}) {
    const Case c = test::case_of(text);
    Case changed = c;
    int count = 0;
    for (const Declaration& d : declarations()) {
      if (!without_effect(d.pointer(), c)) continue;
      std::visit(Change{d.allowed}, d.field(changed));
      ++count;
    }
    EXPECT_GE(count, 5) << text;
    auto expected = test::run_scene(c).summary, found = test::run_scene(changed).summary;
    // What only repeats the case: the tweezer without a fluid names the spacing.
    if (without_effect("/fluid/lattice_spacing_um", c)) expected.erase("dx_um"), found.erase("dx_um");
    EXPECT_EQ(expected.dump(), found.dump()) << text;
  }
}

TEST(Advice, OfAMisplacedNameLeadsToAKeyThatIsRead) {
  const Problem p = problem_of(R"({"scene": "passage", "cell": {"shear_modulus_uN_per_m": 5}})");
  EXPECT_TRUE(contains(p.advice, "use /cell/capillary_number")) << p.advice;
  EXPECT_FALSE(contains(p.advice, "belongs at /stretching")) << p.advice;
  const Problem q = problem_of(R"({"scene": "stretching", "cell": {"shear_modulus_uN_per_m": 5}})");
  EXPECT_TRUE(contains(q.advice, "belongs at /stretching/shear_modulus_uN_per_m")) << q.advice;
}

TEST(Advice, KnowsTheSymbolsOfTheField) {
  for (const auto& [text, part] : std::vector<std::pair<const char*, const char*>>{
           {R"({"scene": "passage", "geometry": {"gap_um": 10}})", "/geometry/pitch_um to 30"},
           {R"({"scene": "passage", "geometry": {"G": 10}})", "/geometry/pillar_radius_um to 11"},
           {R"({"scene": "passage", "geometry": {"H": 4.8}})", "/geometry/depth_um"},
           {R"({"scene": "passage", "geometry": {"lambda": 32}})", "/geometry/pitch_um"},
           {R"({"scene": "passage", "Ca": 1})", "/cell/capillary_number"},
           {R"({"scene": "shear", "tau": 1})", "/fluid/relaxation_time"},
           {R"({"scene": "passage", "geometry": {"depth": 4.8}})", "depth_um"}}) {
    const Problem p = problem_of(text);
    EXPECT_TRUE(contains(p.advice, part)) << text << p.advice;
  }
}

TEST(Advice, IsNoNameThatIsNothingLikeTheGivenOne) {
  const Problem shape = problem_of(R"({"scene": "passage", "geometry": {"pillar_shape": "hexagon"}})");
  EXPECT_TRUE(contains(shape.allowed, "circle"));
  EXPECT_FALSE(contains(shape.advice, "none")) << shape.advice;
  const Problem accuracy = problem_of(R"({"scene": "passage", "accuracy": "high"})");
  EXPECT_FALSE(contains(accuracy.advice, "use \"draft\"")) << accuracy.advice;
  EXPECT_TRUE(contains(accuracy.advice, "reference is for the most accurate")) << accuracy.advice;
  EXPECT_TRUE(contains(problem_of(R"({"scene": "passage", "accuracy": "standart"})").advice, "\"standard\""));
}

TEST(Advice, NamesSpacingsThatFitTheWholeDevice) {
  const auto problems = problems_of(R"({"scene": "passage",
      "geometry": {"pitch_um": 38, "pillar_radius_um": 10.5, "epsilon": 0.1, "depth_um": 9.5}})");
  ASSERT_EQ(problems.size(), 2u);
  for (const Problem& p : problems) EXPECT_TRUE(contains(p.advice, " 0.475 or ")) << p.advice;
  EXPECT_TRUE(problems_of(R"({"scene": "passage", "fluid": {"lattice_spacing_um": 0.475}, "geometry":
      {"pitch_um": 38, "pillar_radius_um": 10.5, "epsilon": 0.1, "depth_um": 9.5}})")
                  .empty());
}

TEST(Advice, NeverChangesEpsilonInSilence) {
  const Problem given = problem_of(R"({"scene": "passage", "geometry": {"epsilon": 0.11}})");
  EXPECT_EQ(given.pointer, "/geometry/epsilon");
  EXPECT_EQ(given.value, "0.11");
  EXPECT_TRUE(contains(given.advice, "use 0.1125, a row shift of 3.6 um")) << given.advice;
  const Problem shift = problem_of(R"({"scene": "passage", "geometry": {"row_shift_um": 2.1}})");
  EXPECT_TRUE(contains(shift.advice, "use 2, which is epsilon 0.0625")) << shift.advice;
  const Problem pitch = problem_of(R"({"scene": "passage", "geometry": {"pitch_um": 31.9}})");
  EXPECT_TRUE(contains(pitch.advice, "use 32, which makes epsilon 0.1875")) << pitch.advice;
}

TEST(Annotations, AreAllowedAtTheTopAndChangeNothing) {
  const Case c =
      parse_case(R"({"$schema": "case.schema.json", "description": "a cell", "scene": "passage"})", "c");
  EXPECT_EQ(echo(c), echo(parse_case(R"({"scene": "passage"})", "c")));
  EXPECT_TRUE(case_schema()["properties"].contains("$schema"));
  EXPECT_TRUE(case_schema()["properties"].contains("description"));
  EXPECT_EQ(problem_of(R"({"scene": "passage", "description": 3})").pointer, "/description");
  EXPECT_EQ(problem_of(R"({"scene": "passage", "cell": {"description": "x"}})").pointer, "/cell/description");
}

TEST(Syntax, PlacesNumbersThatAreTooLarge) {
  const Problem p = problem_of("{\"scene\": \"passage\",\n \"fluid\": {\"force_density\": 1e999}}");
  EXPECT_EQ(p.pointer, "/fluid/force_density");
  EXPECT_TRUE(contains(p.advice, "line 2")) << p.advice;
  EXPECT_FALSE(contains(p.advice, "json.exception")) << p.advice;
  EXPECT_EQ(problem_of(R"({"scene": "stretching", "stretching": {"forces_pN": [1, 2, -1e999]}})").pointer,
            "/stretching/forces_pN/2");
}

TEST(Syntax, PlacesRepeatedNames) {
  const auto problems = problems_of(
      "{\"scene\": \"passage\", \"fluid\": {\"walls\": \"half_way\",\n"
      "  \"walls\": \"half_way\"},\n \"scene\": \"passage\"}");
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].pointer, "/fluid/walls");
  EXPECT_TRUE(contains(problems[0].advice, "line 2, column")) << problems[0].advice;
  EXPECT_EQ(problems[1].pointer, "/scene");
  EXPECT_TRUE(contains(problems[1].advice, "line 3, column")) << problems[1].advice;
}

TEST(Syntax, RefusesDeepNestingWithoutAStackOfItsOwn) {
  for (const char* bracket : {"[", "{\"a\":"}) {
    std::string text;
    for (int i = 0; i < 200000; ++i) text += bracket;
    const Problem p = problem_of(text);
    EXPECT_TRUE(contains(p.allowed, "at most 64")) << p.allowed;
  }
  const std::string deepest = std::string(deepest_json, '[') + std::string(deepest_json, ']');
  std::vector<Problem> problems;
  EXPECT_TRUE(parse_json(deepest, problems).is_array());
  EXPECT_TRUE(problems.empty());
}

TEST(Headline, SaysWhichDeviceCellAndCapillaryNumberIsTaken) {
  const std::string line = headline(parse_case(R"({"scene": "passage"})", "c"));
  for (const char* part : {"circle, radius 10 um", "pitch 32 um", "epsilon 0.1875", "depth 4.8 um",
                           "red_blood_cell", "r = 3.9 um", "Ca = 0.5", "dx = 0.4 um", "standard"})
    EXPECT_TRUE(contains(line, part)) << line;
  const std::string shear = headline(parse_case(R"({"scene": "shear", "cell": {"radius_um": 3}})", "c"));
  EXPECT_TRUE(contains(shear, "Ca = 0.02") && !contains(shear, "pitch")) << shear;
}

}  // namespace
}  // namespace dld
