// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/restore_robot.h"

#include <gtest/gtest.h>

#include "models/import/embedded_robot.h"
#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"
#include "tests/support/maker_robot.h"
#include "tests/support/temp_folder.h"

namespace sidestep::importer {
namespace {

constexpr char kMjcf[] = "<mujoco>\n<worldbody><geom size=\"1\"/></worldbody>\n</mujoco>\n";

/// A robot in `robot`, and an export of it, export.xml.
class RestoreRobotTest : public testing::Test {
 protected:
  RestoreRobotTest() {
    ImportOptions made;
    made.source = WriteMakerRobot(MakerRobot(), folder_.path() / "maker");
    made.folder = folder_.path() / "robot";
    ImportRobot(made);
    Export();
    options_.folder = folder_.path() / "out";
  }

  void Export() {
    const RobotDescription robot = ReadRobotDescription(folder_.path() / "robot/robot.yaml");
    options_.source = folder_.Write("export.xml", WithRobotFiles(kMjcf, robot));
  }

  std::string Error() const {
    return folder_.ErrorOf([&] { ImportRobot(options_); });
  }

  bool HasWritten() const { return std::filesystem::exists(options_.folder); }

  TempFolder folder_;
  ImportOptions options_;
};

TEST_F(RestoreRobotTest, ItsFilesAndScenariosAreWritten) {
  const ImportReport report = ImportRobot(options_);
  EXPECT_EQ(report.files.size(), 5U);
  for (const char* file : {"robot.yaml", "robot.urdf"}) {
    EXPECT_EQ(ReadTextFile(options_.folder / file), ReadTextFile(folder_.path() / "robot" / file));
  }
  EXPECT_TRUE(std::filesystem::exists(options_.folder / "maker_push.yaml"));
}

TEST_F(RestoreRobotTest, WhatWouldChangeTheRobotIsRefusedInOneLine) {
  options_.name = "other";
  options_.mode = "torque";
  EXPECT_EQ(Error(),
            "export.xml: error: carries the robot that it was exported from, which is restored as "
            "it was: leave out --name, --mode, or take the last <custom> out of it to import what "
            "the MJCF tells");
  options_.name.clear();
  options_.mode.clear();
  options_.has_meshes = false;
  options_.packages["meshes"] = folder_.path();
  EXPECT_NE(Error().find("leave out --package, --no-meshes, or"), std::string::npos) << Error();
  EXPECT_FALSE(HasWritten());
}

TEST_F(RestoreRobotTest, ARobotThatIsNoGoodIsNotWrittenInPart) {
  const std::string yaml = ReadTextFile(folder_.path() / "robot/robot.yaml");
  RobotDescription robot = ReadRobotDescription(folder_.path() / "robot/robot.yaml");
  robot.file = folder_.Write("robot/robot.yaml", "sidestep_robot: 9\n" + yaml);
  folder_.Write("export.xml", WithRobotFiles(kMjcf, robot));
  const std::string error = Error();
  EXPECT_EQ(
      error.rfind("export.xml: error: carries a robot that can't be restored (robot.yaml:", 0), 0U)
      << error;
  EXPECT_EQ(error.find('\n'), std::string::npos);
  EXPECT_FALSE(HasWritten());
}

}  // namespace
}  // namespace sidestep::importer
