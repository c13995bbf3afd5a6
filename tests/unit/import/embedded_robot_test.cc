// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/embedded_robot.h"

#include <gtest/gtest.h>

#include <array>

#include "models/mjcf/mjcf.h"
#include "tests/support/temp_folder.h"

namespace sidestep::importer {
namespace {

constexpr char kMjcf[] = "<mujoco>\n<worldbody><geom size=\"1\"/></worldbody>\n</mujoco>\n";

RobotDescription RobotIn(const TempFolder& folder, const std::string& yaml) {
  RobotDescription robot;
  robot.file = folder.Write("my robot.yaml", yaml);
  robot.model = RobotModel{};
  robot.model->language = ModelLanguage::kUrdf;
  robot.model->file =
      folder.Write("my.urdf", "<robot>\n\t<!-- \"quoted\" & 'such' -->\r\n</robot>");
  return robot;
}

RobotDescription PlainRobotIn(const TempFolder& folder, const std::string& yaml = "name: x\n") {
  RobotDescription robot = RobotIn(folder, yaml);
  robot.file = folder.Write("robot.yaml", yaml);
  return robot;
}

TEST(EmbeddedRobot, ItsFilesComeBackByteForByte) {
  const TempFolder folder;
  const RobotDescription robot = PlainRobotIn(folder, "name: x  # '<a>' \"b\"\nlist: [1,\n 2]\n");
  const std::string mjcf = WithRobotFiles(kMjcf, robot);
  const auto files = RobotFilesIn(mjcf);
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 2U);
  EXPECT_EQ((*files)[0].first, "robot.yaml");
  EXPECT_EQ((*files)[0].second, ReadTextFile(robot.file));
  EXPECT_EQ((*files)[1].first, "my.urdf");
  EXPECT_EQ((*files)[1].second, ReadTextFile(robot.model->file));
  EXPECT_TRUE(CompileMjcf(mjcf, "", "export")) << "MuJoCo takes it";
}

TEST(EmbeddedRobot, WhoEditsANumberGetsWhatTheMjcfTells) {
  const TempFolder folder;
  std::string mjcf = WithRobotFiles(kMjcf, PlainRobotIn(folder));
  mjcf.replace(mjcf.find("size=\"1\""), 8, "size=\"2\"");
  EXPECT_FALSE(RobotFilesIn(mjcf));
  std::string yaml = WithRobotFiles(kMjcf, PlainRobotIn(folder));
  yaml.replace(yaml.find("name: x"), 7, "name: y");
  EXPECT_FALSE(RobotFilesIn(yaml));
}

TEST(EmbeddedRobot, NothingIsReadOfAFileWithoutOne) {
  EXPECT_FALSE(RobotFilesIn(kMjcf));
  EXPECT_FALSE(RobotFilesIn(""));
  EXPECT_FALSE(
      RobotFilesIn("<!-- For sidestep robots import: the robot's own files. -->\n<custom>\n"
                   "<text/></custom>\n"));
}

TEST(EmbeddedRobot, NamesThatAreNoPlainFilesAreNotWritten) {
  const TempFolder folder;
  EXPECT_FALSE(RobotFilesIn(WithRobotFiles(kMjcf, RobotIn(folder, "name: x\n"))))
      << "a blank in it";
}

TEST(EmbeddedRobot, ARobotThatNeedsOtherFilesIsNotCarried) {
  const TempFolder folder;
  EXPECT_EQ(WithRobotFiles(kMjcf, PlainRobotIn(folder, "name: x\nmeshes: there\n")), kMjcf);
  RobotDescription elsewhere = PlainRobotIn(folder);
  elsewhere.model->file = folder.Write("other/my.urdf", "<robot/>");
  EXPECT_EQ(WithRobotFiles(kMjcf, elsewhere), kMjcf);
  RobotDescription mjcf = PlainRobotIn(folder);
  mjcf.model->language = ModelLanguage::kMjcf;
  mjcf.model->file = folder.Write("my.xml", "<mujoco><include file=\"a.xml\"/></mujoco>");
  EXPECT_EQ(WithRobotFiles(kMjcf, mjcf), kMjcf);
  RobotDescription none = PlainRobotIn(folder);
  none.model.reset();
  EXPECT_EQ(WithRobotFiles(kMjcf, none), kMjcf);
}

}  // namespace
}  // namespace sidestep::importer
