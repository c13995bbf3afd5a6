// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/scenario_list.h"

#include <nlohmann/json.hpp>

#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::scenario_list_test {
namespace {

/// Two scenarios ship, of a robot that does not: the list reads none.
class ScenarioListTest : public testing::Test {
 protected:
  ScenarioListTest() {
    folder_.Write("scenarios/walk.yaml",
                  "sidestep: 1\nname: walk\nrobot: biped\nduration_s: 12.5\ndescription: Walks.\n");
    folder_.Write("scenarios/run.yaml", "sidestep: 1\nname: run\nbased_on: walk\nduration_s: 3\n");
    setenv("SIDESTEP_DATA_DIR", folder_.path().c_str(), 1);
  }
  ~ScenarioListTest() override { unsetenv("SIDESTEP_DATA_DIR"); }
  const TempFolder folder_;
};

TEST_F(ScenarioListTest, ListsWhatShipsInColumns) {
  EXPECT_EQ(ScenariosText(),
            "SCENARIO  ROBOT     S  DESCRIPTION\n"
            "run       biped     3  Walks.\n"
            "walk      biped  12.5  Walks.\n");
}

TEST_F(ScenarioListTest, JsonTellsTheSameAndTheFile) {
  const auto list = nlohmann::json::parse(ScenariosJson());
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1]["name"], "walk");
  EXPECT_EQ(list[1]["duration_s"], 12.5);
  EXPECT_EQ(list[0]["file"], (folder_.path() / "scenarios/run.yaml").string());
}

TEST_F(ScenarioListTest, AFileThatIsNoScenarioIsToldWithItsPlace) {
  folder_.Write("scenarios/bad.yaml", "sidestep: 1\nname: bad\nrobot: biped\n");
  EXPECT_EQ(folder_.ErrorOf(ScenariosText),
            "scenarios/bad.yaml:1:1: error: duration_s is missing (required)");
}

}  // namespace
}  // namespace sidestep::scenario_list_test
