/// `dld resolve`: one answer for each case, from the rules that the scenes give of themselves.
#include "parameters/resolve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "fluid/lattice.hpp"
#include "parameters/consistency.hpp"
#include "parameters/declaration.hpp"
#include "parameters/limits.hpp"
#include "parameters/memory.hpp"
#include "parameters/reader.hpp"
#include "parameters/work.hpp"
#include "scene/registry.hpp"
#include "scene/setup.hpp"

namespace dld {
namespace {

namespace fs = std::filesystem;

const fs::path data_folder = fs::path(DLD_SOURCE_DIR) / "tests" / "data";

// Everything that the reader says of a file, said by the answer too.
TEST(Resolve, HasTheProblemsOfTheReader) {
  int checked = 0;
  for (const char* folder : {"bad", "inconsistent", "good"}) {
    for (const auto& entry : fs::directory_iterator(data_folder / folder)) {
      std::vector<Problem> expected;
      try {
        read_case(entry.path());
      } catch (const CaseError& error) {
        expected = error.problems;
      }
      const std::string text = read_text(entry.path());
      if (text.starts_with("[")) continue;  // a list of cases, and not one that is wrong
      nlohmann::ordered_json answers;
      try {
        answers = resolve_text(text, "cases.json");
      } catch (const CaseError&) {
        EXPECT_FALSE(expected.empty()) << entry.path();  // no JSON at all
        continue;
      }
      ASSERT_EQ(answers.size(), 1u) << entry.path();
      const auto& found = answers[0]["problems"];
      ASSERT_EQ(found.size(), expected.size()) << entry.path();
      for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(found[k]["pointer"], expected[k].pointer) << entry.path();
        EXPECT_EQ(found[k]["value"], expected[k].value);
        EXPECT_EQ(found[k]["allowed"], expected[k].allowed);
        EXPECT_EQ(found[k]["advice"], expected[k].advice);
      }
      EXPECT_EQ(answers[0].contains("case"), expected.empty()) << entry.path();
      ++checked;
    }
  }
  EXPECT_GT(checked, 30);
}

TEST(Resolve, AnswersEachCaseOfAList) {
  const auto answers = resolve_text(
      R"([{"scene": "streamlines"}, {"scene": "passage", "geometry": {"row_shift_um": 40}}, 5,
          {"scene": "passage", "fluid": {"force_density": 0.1}}])",
      "cases.json");
  ASSERT_EQ(answers.size(), 4u);
  EXPECT_EQ(answers[0]["case"]["scene"], "streamlines");
  EXPECT_EQ(answers[0]["sections"], (std::vector<std::string>{"geometry", "fluid", "stop", "output"}));
  EXPECT_FALSE(answers[0]["expected_to_diverge"].get<bool>());
  EXPECT_EQ(answers[1]["problems"][0]["pointer"], "/geometry/row_shift_um");
  EXPECT_EQ(answers[2]["problems"][0]["allowed"], "an object");
  EXPECT_TRUE(answers[3]["expected_to_diverge"].get<bool>());
  EXPECT_FALSE(answers[3]["warnings"].empty());
}

// A thousand cases are answered while a user waits for nothing.
TEST(Resolve, IsFast) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (int k = 0; k < 1000; ++k) {
    cases.push_back({{"scene", "passage"},
                     {"geometry", {{"row_shift_um", 0.4 * (1 + k % 20)}}},
                     {"cell", {{"capillary_number", 0.1 + 0.001 * k}}}});
  }
  const std::string text = cases.dump();
  const std::clock_t begin = std::clock();  // of the processor: others may be at work on the machine
  EXPECT_EQ(resolve_text(text, "cases.json").size(), 1000u);
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

TEST(SceneRules, NameKnownSections) {
  const auto known = sections();
  ASSERT_EQ(scene_rules().size(), scene_names().size());
  for (const auto& rules : scene_rules()) {
    EXPECT_NE(find_scene(rules.name), nullptr) << rules.name;
    for (const auto& section : rules.sections) {
      EXPECT_NE(std::ranges::find(known, section), known.end()) << rules.name << " " << section;
    }
  }
}

TEST(SceneRules, ReachTheSchema) {
  const auto scene = case_schema()["properties"]["scene"];
  EXPECT_EQ(scene["enum"], scene_names());
  for (const auto& rules : scene_rules()) EXPECT_EQ(scene["x-sections"][rules.name], rules.sections);
}

TEST(Work, OfEverySceneIsPositive) {
  for (const auto& rules : scene_rules()) {
    Case c;
    c.scene = rules.name;
    const ExpectedWork work = rules.work(c);
    EXPECT_GT(work.steps, 0) << rules.name;
    EXPECT_GT(work.node_updates + work.membrane_updates, 0) << rules.name;
    EXPECT_GT(work.seconds_on_one_core, 0) << rules.name;
    EXPECT_GT(memory_MiB(c), 0) << rules.name;
  }
}

// Slower flow, more steps; a run of a given number of rows goes by them.
TEST(Work, OfAPassageGoesWithItsRowsAndItsSpeed) {
  Case c;
  const double typical = passage_work(c).steps_per_row;
  c.fluid.force_density /= 2;
  EXPECT_NEAR(passage_work(c).steps_per_row, 2 * typical, 1e-9 * typical);
  c.stop.when = "rows";
  c.stop.max_rows = 100;
  EXPECT_GT(passage_work(c).steps, 100 * 2 * typical);
}

}  // namespace
}  // namespace dld
