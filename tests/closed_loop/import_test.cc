// SPDX-License-Identifier: BSD-3-Clause
// A maker's robot, imported by the program and run at once: no line of it is edited.

#include <gtest/gtest.h>

#include <string>

#include "sim/episode/run_episode.h"
#include "tests/support/maker_robot.h"
#include "tests/support/sidestep_program.h"
#include "tests/support/temp_folder.h"

namespace sidestep::import_test {
namespace {

MakerRobot Named(const std::string& name) {
  MakerRobot maker;
  maker.name = name;
  if (name == "meshes") {
    maker.has_mesh_shapes = true;
    maker.has_gram_frames = true;
    maker.foot = MakerFoot::kMesh;
  } else if (name == "trunk") {
    maker.is_rooted_in_trunk = true;
  } else if (name == "spheres") {
    maker.foot = MakerFoot::kSpheres;
    maker.bends_hips_first = true;
    maker.has_wild_limits = true;
  } else {
    maker.has_fingers = true;
    maker.has_floating_root = true;
    maker.size = 0.7;
  }
  return maker;
}

class Import : public testing::TestWithParam<std::string> {
 protected:
  Import() {
    const std::filesystem::path urdf = WriteMakerRobot(Named(GetParam()), folder_.path() / "maker");
    const ProcessResult result = Sidestep({"robots", "import", urdf, "-o", folder_.path() / "out"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }

  /// Runs a scenario of the import and expects PASS.
  void ExpectPass(const std::string& what, const std::vector<std::string>& overrides = {}) {
    std::vector<std::string> words{
        "run",       folder_.path() / "out" / (GetParam() + "_" + what + ".yaml"),
        "-o",        folder_.path() / "run",
        "--force",   "--no-video",
        "--no-plots"};
    for (const std::string& key : overrides) words.insert(words.end(), {"--set", key});
    const ProcessResult result = Sidestep(words);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  }

  TempFolder folder_;
};

TEST_P(Import, Stands) { ExpectPass("stand"); }

TEST_P(Import, Walks) { ExpectPass("walk"); }

TEST_P(Import, SurvivesAPushFromFourSidesInFourPhases) {
  for (const char* direction : {"0", "1.5708", "3.1416", "-1.5708"}) {
    for (const char* phase : {"mid_swing", "swing_to_stance", "mid_stance", "stance_to_swing"}) {
      SCOPED_TRACE(std::string(direction) + " rad at " + phase);
      ExpectPass("push", {"duration_s=8", std::string("pushes.0.direction_rad=") + direction,
                          std::string("pushes.0.at_phase=") + phase});
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Makers, Import, testing::Values("meshes", "trunk", "spheres", "fingers"),
                         [](const auto& info) { return info.param; });

TEST(ImportCommand, RefusesAFolderThatHoldsSomething) {
  const TempFolder folder;
  const std::filesystem::path urdf = WriteMakerRobot(MakerRobot(), folder.path());
  const auto import = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"robots", "import", urdf, "-o", folder.path() / "out"};
    words.insert(words.end(), more.begin(), more.end());
    return Sidestep(words).exit_code;
  };
  folder.Write("out/precious.txt", "mine");
  EXPECT_EQ(import({}), 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/robot.yaml"));
  EXPECT_EQ(import({"--force"}), 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/precious.txt"));
  EXPECT_EQ(import({"--force", "--name", "no name"}), 2);
  EXPECT_EQ(import({"--force", "--package", "x"}), 2);
  EXPECT_EQ(import({"--force", "--mode", "passive"}), 2);
}

}  // namespace
}  // namespace sidestep::import_test
