// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/run_scenario.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "models/support/config_error.h"
#include "tests/support/run_files.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/episode/episode_test_support.h"

namespace sidestep::run_scenario_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles[] = {"scenario.yaml", "trajectory.csv", "states.bin",
                                  "mpc.csv",       "footsteps.csv",  "summary.json"};

nlohmann::json SummaryOf(const fs::path& run_dir) {
  return nlohmann::json::parse(TextOf(run_dir / "summary.json"));
}

RunOptions Into(const fs::path& out_dir) {
  RunOptions options;
  options.out_dir = out_dir;
  return options;
}

TEST(RunScenarioTest, AUsersControllerLeavesAllFilesAndAVerdict) {
  const TempFolder folder;
  auto seen = std::make_shared<Frames>();
  RunOptions options = Into(folder.path() / "a/new/folder");
  options.command = {"my_program", "--fast"};
  int num_calls = 0;
  options.progress = [&](double, double) { ++num_calls; };
  const RunResult result = RunScenario(ShortHop(0.1), options, TorqueBy(NoTorque, seen));
  EXPECT_EQ(seen->size(), 51u) << "it was the one that was asked";
  EXPECT_EQ(num_calls, 2) << "at 0 and 0.1 s";
  EXPECT_EQ(result.out_dir, options.out_dir);
  EXPECT_EQ(result.verdict.verdict_class, VerdictClass::kPass);
  for (const char* name : kFiles) EXPECT_NE(TextOf(options.out_dir / name), "") << name;
  const nlohmann::json summary = SummaryOf(options.out_dir);
  EXPECT_EQ(summary["verdict"], "PASS");
  EXPECT_EQ(summary["command"], nlohmann::json({"my_program", "--fast"}));
  EXPECT_DOUBLE_EQ(summary["simulated_s"].get<double>(), 0.1);
  EXPECT_GT(summary["wall_s"].get<double>(), 0.0);
  EXPECT_FALSE(fs::exists(options.out_dir / "problems")) << "it solved none";
}

TEST(RunScenarioTest, AFallIsTheSameFailInTheAnswerAndInTheSummary) {
  const TempFolder folder;
  const RunResult result = RunScenario(FallingHopper(), Into(folder.path()), TorqueBy(NoTorque));
  EXPECT_EQ(result.verdict.verdict_class, VerdictClass::kFail);
  ASSERT_FALSE(result.verdict.reasons.empty());
  const nlohmann::json summary = SummaryOf(folder.path());
  EXPECT_EQ(summary["verdict"], "FAIL");
  EXPECT_EQ(summary["reasons"][0]["class"], "FALL");
  EXPECT_EQ(summary["reasons"][0]["text"], result.verdict.reasons[0].text);
  EXPECT_LT(summary["simulated_s"].get<double>(), 5.0) << "half a second after the fall";
}

TEST(RunScenarioTest, ARunThatDivergedStillLeavesAllFiles) {
  const TempFolder folder;
  const auto law = [](const SensorFrame& frame, int) {
    return Eigen::VectorXd::Constant(frame.joint_position.size(),
                                     std::numeric_limits<double>::quiet_NaN());
  };
  const RunResult result = RunScenario(ShortHop(0.1), Into(folder.path()), TorqueBy(law));
  EXPECT_EQ(result.verdict.verdict_class, VerdictClass::kInvalid);
  EXPECT_EQ(SummaryOf(folder.path())["verdict"], "INVALID");
  EXPECT_EQ(SummaryOf(folder.path())["reasons"][0]["class"], "DIVERGED");
  for (const char* name : kFiles) EXPECT_NE(TextOf(folder.path() / name), "") << name;
}

TEST(RunScenarioTest, ARunThatAnErrorEndsSaysSo) {
  const TempFolder folder;
  const auto law = [](const SensorFrame& frame, int num_before) {
    if (frame.tick >= 60) throw std::runtime_error("the gyro caught fire");
    return NoTorque(frame, num_before);
  };
  EXPECT_THROW(RunScenario(ShortHop(0.2), Into(folder.path()), TorqueBy(law)), std::runtime_error);
  const nlohmann::json summary = SummaryOf(folder.path());
  EXPECT_EQ(summary["verdict"], "INVALID");
  EXPECT_EQ(summary["reasons"][0]["class"], "ERROR");
  EXPECT_EQ(summary["reasons"][0]["text"], "the gyro caught fire");
  for (const char* name : kFiles) EXPECT_NE(TextOf(folder.path() / name), "") << name;
}

TEST(RunScenarioTest, TheVerdictIsToldAlsoWhereTheDiskNoLongerTakesItsFiles) {
  const TempFolder folder;
  const fs::path out = folder.path() / "run";
  RunOptions options;
  options.out_dir = out;
  std::optional<VerdictClass> told;
  options.on_verdict = [&](const RunResult& result) {
    told = result.verdict.verdict_class;
    fs::remove_all(out);
  };
  EXPECT_THROW(RunScenario(ShortHop(0.1), options, TorqueBy(NoTorque)), ConfigError);
  EXPECT_EQ(told, VerdictClass::kPass);
}

TEST(RunScenarioTest, UntilItIsJudgedTheFolderSaysInvalidAndHasWholeRows) {
  const TempFolder folder;
  nlohmann::json summary_before;
  std::string rows_before;
  const auto law = [&](const SensorFrame& frame, int num_before) {
    if (frame.tick == 150) {  // as a reader would find it if the power failed here
      summary_before = SummaryOf(folder.path());
      rows_before = TextOf(folder.path() / "trajectory.csv");
    }
    return NoTorque(frame, num_before);
  };
  RunScenario(ShortHop(0.2), Into(folder.path()), TorqueBy(law));
  EXPECT_EQ(summary_before["verdict"], "INVALID");
  EXPECT_EQ(summary_before["reasons"][0]["class"], "INTERRUPTED");
  EXPECT_GE(std::count(rows_before.begin(), rows_before.end(), '\n'), 50) << "a tenth of a second";
  EXPECT_EQ(rows_before.back(), '\n');
}

TEST(RunScenarioTest, EveryProblemOfTheShippedControllerIsKeptOnRequest) {
  const TempFolder folder;
  RunOptions options = Into(folder.path());
  options.dump_every_problem = true;
  RunScenario(ShortHop(0.12), options);
  for (const char* name : {"mpc_0000000.json", "mpc_0000050.json", "mpc_0000100.json"}) {
    EXPECT_FALSE(nlohmann::json::parse(TextOf(folder.path() / "problems" / name)).empty()) << name;
  }
}

TEST(RunScenarioTest, AFolderThatCannotBeMadeIsAMistakeBeforeTheControllerIsAsked) {
  const TempFolder folder;
  const fs::path file = folder.Write("file", "of the user's");
  auto seen = std::make_shared<Frames>();
  EXPECT_THROW(RunScenario(ShortHop(0.1), Into(file / "out"), TorqueBy(NoTorque, seen)),
               ConfigError);
  EXPECT_EQ(seen->size(), 0u);
  EXPECT_EQ(TextOf(file), "of the user's");
}

}  // namespace
}  // namespace sidestep::run_scenario_test
