// SPDX-License-Identifier: BSD-3-Clause
// What is in the folder of a run that did not come to its end, and of one that can't be written.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "models/support/config_error.h"
#include "sim/record/recorder.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::recorder_cut_short_test {
namespace {

using RecorderCutShortTest = RecordTest;

TEST_F(RecorderCutShortTest, FilesOnDiskEndWithWholeRowsWhileTheRunGoesOn) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  Recorder recorder(scenario, world, folder_, {});
  // 1,000 rows exceed every buffer.
  for (Tick tick = 0; tick < 2000; tick += 2) {
    recorder.Add(tick, world.truth(), BusyControl(tick), TimesOf(1.0, 1.0, 0.125));
  }
  const std::string text = ReadWholeFile(folder_ / "trajectory.csv");
  EXPECT_EQ(text.back(), '\n');
  EXPECT_GT(CsvTable::Read(folder_ / "trajectory.csv").num_rows(), 500u);
  EXPECT_GT(ReadStates(folder_).rows.size(), 500u);
  EXPECT_EQ(ReadSummary(folder_).verdict, VerdictClass::kInvalid);
}

TEST_F(RecorderCutShortTest, RunThatIsAbandonedKeepsEveryRow) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  {
    Recorder recorder(scenario, world, folder_, {});
    for (Tick tick = 0; tick < 20; tick += 2) {
      recorder.Add(tick, world.truth(), BusyControl(tick), TimesOf(1.0, 1.0, 0.125));
    }
  }
  EXPECT_EQ(CsvTable::Read(folder_ / "trajectory.csv").num_rows(), 10u);
  EXPECT_EQ(CsvTable::Read(folder_ / "mpc.csv").num_rows(), 10u);
  EXPECT_EQ(ReadStates(folder_).rows.size(), 10u);
}

TEST_F(RecorderCutShortTest, OlderSummaryDoesNotOutliveTheStartOfANewRun) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  RunOutcome outcome;
  outcome.footsteps.resize(1);
  Recorder(scenario, world, folder_, {}).Finish(outcome, 1.0, {1.0, 1.0});
  ASSERT_EQ(ReadSummary(folder_).verdict, VerdictClass::kPass);
  const Recorder recorder(scenario, world, folder_, {});
  const RunSummary summary = ReadSummary(folder_);
  EXPECT_EQ(summary.verdict, VerdictClass::kInvalid);
  ASSERT_EQ(summary.reasons.size(), 1U);
  EXPECT_EQ(summary.reasons[0].kind, reason::kInterrupted);
  EXPECT_EQ(ReadFootsteps(folder_).size(), 0U);
}

TEST_F(RecorderCutShortTest, NoTemporaryFileIsLeft) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  Recorder(scenario, world, folder_, {}).Finish({}, 1.0, {1.0, 1.0});
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names,
            (std::vector<std::string>{"footsteps.csv", "mpc.csv", "run_files.txt", "scenario.yaml",
                                      "states.bin", "summary.json", "trajectory.csv"}));
}

TEST_F(RecorderCutShortTest, FolderThatCantBeMadeIsTheUsersMistake) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  std::ofstream(folder_) << "a file, not a folder";
  EXPECT_THROW(Recorder(scenario, world, folder_ / "run", {}), ConfigError);
}

TEST_F(RecorderCutShortTest, FullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  std::filesystem::create_directories(folder_);
  std::filesystem::create_symlink("/dev/full", folder_ / "mpc.csv");
  Recorder recorder(scenario, world, folder_, {});
  EXPECT_THROW(recorder.Finish({}, 1.0, {1.0, 1.0}), ConfigError);
}

}  // namespace
}  // namespace sidestep::recorder_cut_short_test
