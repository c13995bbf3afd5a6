// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/find_scenarios.h"

#include <gtest/gtest.h>

#include "models/support/config_error.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep::find_scenarios_test {
namespace {

using Paths = std::vector<std::filesystem::path>;

TEST(FindScenariosTest, FoldersAreSearchedAtAnyDepthAndSorted) {
  const ScratchFolder folder;
  const auto b = folder.Write("b.yaml", "");
  const auto deep = folder.Write("a/deep/c.yaml", "");
  folder.Write("notes.md", "");
  EXPECT_EQ(FindScenarios({folder.path()}), (Paths{deep, b}));
}

TEST(FindScenariosTest, AFileNamedTwiceIsFoundOnce) {
  const ScratchFolder folder;
  const auto a = folder.Write("a.yaml", "");
  EXPECT_EQ(FindScenarios({a, folder.path()}).size(), 1U);
}

TEST(FindScenariosTest, AFileMayHaveAnyName) {
  const ScratchFolder folder;
  const auto odd = folder.Write("scenario.txt", "");
  EXPECT_EQ(FindScenarios({odd}), Paths{odd});
}

TEST(FindScenariosTest, SweepsInAFolderAreFoundOnlyWhereTheyAreAskedFor) {
  const ScratchFolder folder;
  const auto sweep = folder.Write("maps/a.yaml", "name: a\nsidestep_sweep: 1\n");
  EXPECT_THROW(FindScenarios({folder.path()}), ConfigError) << "it holds nothing else";
  const auto scenario = folder.Write("b.yaml", "sidestep: 1\nname: sidestep_sweep\n");
  const auto broken = folder.Write("c.yaml", "sidestep_sweep: [1\n");
  EXPECT_EQ(FindScenarios({folder.path()}), (Paths{scenario, broken})) << "what's broken is told";
  EXPECT_EQ(FindScenarios({folder.path()}, SweepFiles::kFound), (Paths{scenario, broken, sweep}));
  EXPECT_EQ(FindScenarios({sweep}), Paths{sweep}) << "as given";
}

TEST(FindScenariosTest, RobotsAndWhatRunsAndSweepsHaveWrittenArePassedOver) {
  const ScratchFolder folder;
  const auto scenario = folder.Write("a.yaml", "sidestep: 1\n");
  folder.Write("robot.yaml", "sidestep_robot: 1\n");
  folder.Write("renders/a/scenario.yaml", "sidestep: 1\n");
  folder.Write("renders/a/run_files.txt", "sidestep-run-files 1\n");
  folder.Write("renders/old/scenario.yaml", "sidestep: 1\n");
  folder.Write("renders/old/trajectory.csv", "time_s\n");
  folder.Write("renders/map/sweep.yaml", "sidestep_sweep: 1\n");
  folder.Write("renders/map/manifest.csv", "");
  EXPECT_EQ(FindScenarios({folder.path()}, SweepFiles::kFound), Paths{scenario});
  const auto own = folder.path() / "renders/a/scenario.yaml";
  EXPECT_EQ(FindScenarios({own}), Paths{own}) << "as given";
  EXPECT_EQ(FindScenarios({own.parent_path()}), Paths{own}) << "asked for by its folder";
}

TEST(FindScenariosTest, AMissingPathAndAFolderWithoutScenariosAreErrors) {
  const ScratchFolder folder;
  EXPECT_THROW(FindScenarios({folder.path() / "none.yaml"}), ConfigError);
  EXPECT_THROW(FindScenarios({folder.path()}), ConfigError);
}

}  // namespace
}  // namespace sidestep::find_scenarios_test
