// SPDX-License-Identifier: BSD-3-Clause
// `limit` as the shell sees it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/process/process.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep::limit_command_test {
namespace {

ProcessResult Limit(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "limit");
  return Sidestep(arguments);
}

TEST(LimitCommandTest, TellsOfARobotOfAScenarioAndOfARobotsFile) {
  const ProcessResult robot = Limit({"biped", "--phases", "2"});
  EXPECT_EQ(robot.exit_code, 0) << robot.err;
  EXPECT_EQ(robot.out.rfind("biped: walk, steps free", 0), 0U) << robot.out;
  EXPECT_NE(robot.out.find("\n50% "), std::string::npos) << robot.out;
  const ProcessResult scenario = Limit({"hopper_push", "--phases", "named"});
  EXPECT_EQ(scenario.exit_code, 0) << scenario.err;
  EXPECT_NE(scenario.out.find("\nmid_flight "), std::string::npos) << scenario.out;
  const ProcessResult file =
      Limit({std::string(SIDESTEP_SOURCE_DIR) + "/models/rabbit/robot.yaml", "--steps", "none"});
  EXPECT_EQ(file.exit_code, 0) << file.err;
  EXPECT_NE(file.out.find("all: min 0.00, mean 0.00 N s/kg"), std::string::npos)
      << "point feet bear nothing: " << file.out;
}

TEST(LimitCommandTest, WritesATableAndReplacesOneOnlyWhenAsked) {
  const ScratchFolder folder;
  const std::string file = folder.path() / "limit.csv";
  const std::vector<std::string> words{
      "icub_torque_push", "--directions", "4", "--phases", "named", "--at", "chest", "-o", file};
  const ProcessResult result = Limit(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string text = TextOf(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 4 * 4) << text;
  EXPECT_NE(text.find("\nbefore_landing,0.3500,4.71239,"), std::string::npos) << text;
  EXPECT_EQ(Limit(words).exit_code, 2);
  std::vector<std::string> forced = words;
  forced.emplace_back("--force");
  EXPECT_EQ(Limit(forced).exit_code, 0);
  EXPECT_EQ(TextOf(file), text);
}

TEST(LimitCommandTest, MistakesAreOneLine) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"no_such_robot"},
                                             {"biped_run"},
                                             {"biped", "--steps", "all"},
                                             {"biped", "--phases", "0"},
                                             {"biped", "--phases", "often"},
                                             {"biped", "--directions", "0"},
                                             {"biped", "--push-s", "-1"},
                                             {"biped", "--at", "no_such_part"},
                                             {"biped", "--assume", "reach=1"},
                                             {"biped", "--set", "gait.swing=1"},
                                             {"two_legs", "--at", "left"}}) {
    std::vector<std::string> words{"limit"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    ExpectMistake(words);
  }
}

}  // namespace
}  // namespace sidestep::limit_command_test
