// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <stdlib.h>

#include "models/robot_description/robot_description.h"
#include "tests/support/temp_folder.h"

namespace sidestep::find_robot_test {
namespace {

/// Robots `a` and `b` in a models folder of the test's own, beside a folder without a robot.yaml.
class FindRobotTest : public testing::Test {
 protected:
  FindRobotTest() {
    for (const char* file : {"models/b/robot.yaml", "models/a/robot.yaml", "models/mjcf/mjcf.h"}) {
      folder_.Write(file, "");
    }
    setenv("SIDESTEP_DATA_DIR", folder_.path().c_str(), 1);
  }
  ~FindRobotTest() override { unsetenv("SIDESTEP_DATA_DIR"); }

  const TempFolder folder_;
};

TEST_F(FindRobotTest, ListsOnlyFoldersWithARobotFileSorted) {
  EXPECT_EQ(ShippedRobots(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(FindRobotTest, FindsAShippedRobotFromAnywhere) {
  EXPECT_EQ(FindRobot("a", "/nowhere"), folder_.path() / "models/a/robot.yaml");
}

TEST_F(FindRobotTest, FindsAPathRelativeToTheScenario) {
  folder_.Write("mine/robot.yaml", "");
  folder_.Write("scenarios/x.yaml", "");
  EXPECT_EQ(FindRobot("../mine/robot.yaml", folder_.path() / "scenarios"),
            folder_.path() / "mine/robot.yaml");
}

TEST_F(FindRobotTest, FindsAnAbsolutePath) {
  const std::filesystem::path file = folder_.Write("mine.yaml", "");
  EXPECT_EQ(FindRobot(file.string(), "/nowhere"), file);
}

TEST_F(FindRobotTest, FindsNothingForAnUnknownNameOrAFolder) {
  EXPECT_EQ(FindRobot("c", folder_.path()), "");
  EXPECT_EQ(FindRobot("", folder_.path()), "");
  EXPECT_EQ(FindRobot("models/a", folder_.path()), "");
}

TEST_F(FindRobotTest, ListsNothingWhereThereIsNoFolder) {
  setenv("SIDESTEP_DATA_DIR", "/nowhere/at/all", 1);
  EXPECT_TRUE(ShippedRobots().empty());
}

TEST_F(FindRobotTest, FallsBackToTheSourceTree) {
  unsetenv("SIDESTEP_DATA_DIR");
  EXPECT_EQ(FindRobot("one_leg", ""),
            std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models/one_leg/robot.yaml");
}

TEST_F(FindRobotTest, EveryRobotThatShipsCanBeRead) {
  unsetenv("SIDESTEP_DATA_DIR");
  const std::vector<std::string> robots = ShippedRobots();
  EXPECT_GE(robots.size(), 3U);
  for (const std::string& name : robots) {
    const RobotDescription robot = ReadRobotDescription(FindRobot(name, ""));
    EXPECT_EQ(robot.name, name);
    EXPECT_FALSE(NamesIn(robot).bodies.empty());
  }
}

}  // namespace
}  // namespace sidestep::find_robot_test
