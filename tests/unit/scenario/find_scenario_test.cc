// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/find_scenario.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

/// Scenarios `hop` and `walk` ship; the test stands in an empty folder of its own.
class FindScenarioTest : public testing::Test {
 protected:
  FindScenarioTest() : came_from_(std::filesystem::current_path()) {
    for (const char* file : {"data/scenarios/walk.yaml", "data/scenarios/hop.yaml",
                             "data/scenarios/notes.md", "here/.keep"}) {
      folder_.Write(file, "");
    }
    setenv("SIDESTEP_DATA_DIR", (folder_.path() / "data").c_str(), 1);
    std::filesystem::current_path(folder_.path() / "here");
  }
  ~FindScenarioTest() override {
    unsetenv("SIDESTEP_DATA_DIR");
    std::filesystem::current_path(came_from_);
  }

  std::string ErrorOf(const std::string& word) const {
    return folder_.ErrorOf([&] { FindScenario(word); });
  }

  const std::filesystem::path came_from_;
  const TempFolder folder_;
};

TEST_F(FindScenarioTest, ShippedScenariosAreListedByNameSorted) {
  EXPECT_EQ(ShippedScenarios(), (std::vector<std::string>{"hop", "walk"}));
}

TEST_F(FindScenarioTest, ABareNameIsAShippedScenarioWithItsExtensionOrWithout) {
  EXPECT_EQ(FindScenario("hop"), folder_.path() / "data/scenarios/hop.yaml");
  EXPECT_EQ(FindScenario("hop.yaml"), folder_.path() / "data/scenarios/hop.yaml");
}

TEST_F(FindScenarioTest, AFileThatIsThereGoesBeforeAShippedOne) {
  folder_.Write("here/hop.yaml", "");
  EXPECT_EQ(FindScenario("hop.yaml"), "hop.yaml");
  EXPECT_EQ(FindScenario("hop"), folder_.path() / "data/scenarios/hop.yaml");
}

TEST_F(FindScenarioTest, AFolderOfAShippedNameIsNoScenario) {
  folder_.Write("here/hop/summary.json", "");  // what a run of it may leave
  EXPECT_EQ(FindScenario("hop"), folder_.path() / "data/scenarios/hop.yaml");
  folder_.Write("here/mine/summary.json", "");
  EXPECT_EQ(ErrorOf("mine"), "mine: error: is a folder; scenarios that ship: hop, walk");
}

TEST_F(FindScenarioTest, AWrongNameIsToldTheNearestOne) {
  EXPECT_EQ(ErrorOf("wakl"), "wakl: error: does not exist; did you mean 'walk'?");
  EXPECT_EQ(ErrorOf("wolk.yaml"), "wolk.yaml: error: does not exist; did you mean 'walk'?");
  EXPECT_EQ(ErrorOf("swim"), "swim: error: does not exist; scenarios that ship: hop, walk");
}

TEST_F(FindScenarioTest, APathIsNeverLookedForAmongTheShippedOnes) {
  EXPECT_EQ(ErrorOf("./hop"), "./hop: error: does not exist");
  EXPECT_EQ(ErrorOf("no/walk.yaml"), "no/walk.yaml: error: does not exist");
}

}  // namespace
}  // namespace sidestep
