// SPDX-License-Identifier: BSD-3-Clause
// The program finds what ships with it wherever it is put, and shipped scenarios by their names.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "sim/process/process.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

/// A prefix with bin/sidestep and, in share/sidestep, robot `moved` and scenario `moved_stand`,
/// which the source tree doesn't have.
class InstalledProgramTest : public testing::Test {
 protected:
  InstalledProgramTest() {
    const fs::path share = prefix_.path() / "share/sidestep";
    fs::create_directories(prefix_.path() / "bin");
    fs::copy_file(SIDESTEP_BINARY, program_);
    fs::create_directories(share / "models");
    fs::copy(fs::path(SIDESTEP_SOURCE_DIR) / "models/hopper", share / "models/moved");
    prefix_.Write("share/sidestep/scenarios/moved_stand.yaml",
                  "sidestep: 1\nname: moved_stand\nrobot: moved\nduration_s: 0.1\n");
  }

  ProcessResult Run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), program_);
    return RunProcess(arguments, "", {prefix_.path()});
  }

  const ScratchFolder prefix_;
  const fs::path program_{prefix_.path() / "bin/sidestep"};
};

TEST_F(InstalledProgramTest, HasTheRobotsBesideItAndNotTheSourceTrees) {
  const ProcessResult result = Run({"robots"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("moved"), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("icub3"), std::string::npos) << result.out;
}

TEST_F(InstalledProgramTest, RunsAndValidatesAShippedScenarioByItsName) {
  const ProcessResult run = Run({"run", "moved_stand", "--no-video", "--no-plots", "-q"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(prefix_.path() / "renders/moved_stand/summary.json"));
  EXPECT_EQ(Run({"validate", "moved_stand.yaml"}).exit_code, 0);
}

TEST_F(InstalledProgramTest, TellsTheNearestShippedScenarioOfAWrongName) {
  for (const char* command : {"run", "validate", "check"}) {
    const ProcessResult result = Run({command, "moved_stnad"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "moved_stnad: error: does not exist; did you mean 'moved_stand'?\n");
  }
}

}  // namespace
}  // namespace sidestep
