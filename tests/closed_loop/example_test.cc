// SPDX-License-Identifier: BSD-3-Clause
// The example of a user's own controller: it gets verdicts like those that ship.

#include <gtest/gtest.h>

#include <string>

#include "sim/process/process.h"
#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

ProcessResult Statue(const std::string& scenario, const TempFolder& folder) {
  return RunProcess({SIDESTEP_STATUE, scenario, (folder.path() / "run").string()});
}

TEST(ExampleTest, TheStatueStandsAndPasses) {
  const TempFolder folder;
  const ProcessResult result = Statue("icub_stand", folder);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(result.out, "PASS\n");
}

TEST(ExampleTest, TheStatueFailsUnderAShove) {
  const TempFolder folder;
  const ProcessResult result = Statue("icub_stand_push", folder);
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_EQ(result.out.substr(0, 5), "FAIL\n") << result.out;
}

TEST(ExampleTest, AnUnknownScenarioIsAMistakeThatNamesTheNearest) {
  const TempFolder folder;
  const ProcessResult result = Statue("icub_stadn", folder);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("icub_stand"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace sidestep
