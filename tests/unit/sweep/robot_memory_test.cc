// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/robot_memory.h"

#include <gtest/gtest.h>

#include "tests/support/run_files.h"
#include "tests/support/temp_folder.h"

namespace sidestep::robot_memory_test {
namespace {

namespace fs = std::filesystem;

const fs::path kHopper = fs::path(SIDESTEP_SOURCE_DIR) / "models/hopper";

class RobotMemoryTest : public testing::Test {
 protected:
  RobotMemoryTest() {
    folder_.Write("robot.yaml", TextOf(kHopper / "robot.yaml"));
    folder_.Write("hopper.xml", model_);
  }
  RobotDescription Read() { return memory_.Read(folder_.path() / "robot.yaml"); }

  const TempFolder folder_;
  const std::string model_ = TextOf(kHopper / "hopper.xml");
  RobotMemory memory_;
};

TEST_F(RobotMemoryTest, IsWhatIsRead) {
  const RobotDescription read = ReadRobotDescription(folder_.path() / "robot.yaml");
  for (int i = 0; i < 2; ++i) {
    const RobotDescription robot = Read();
    EXPECT_EQ(robot.name, read.name);
    EXPECT_EQ(robot.file, read.file);
    EXPECT_EQ(robot.model->simulated_mjcf, model_);
    EXPECT_EQ(robot.feet.size(), read.feet.size());
  }
}

TEST_F(RobotMemoryTest, AChangeOfEitherFileIsSeen) {
  const double height_m = Read().com_height_m;
  folder_.Write("hopper.xml", model_ + "<!-- another -->\n");
  EXPECT_EQ(Read().model->simulated_mjcf, model_ + "<!-- another -->\n");
  const std::string text = TextOf(kHopper / "robot.yaml");
  const std::size_t key = text.find("com_height_m:");
  ASSERT_NE(key, std::string::npos);
  folder_.Write("robot.yaml",
                text.substr(0, key) + "com_height_m: 0.515" + text.substr(text.find('\n', key)));
  EXPECT_EQ(Read().com_height_m, 0.515);
  EXPECT_NE(height_m, 0.515);
}

TEST_F(RobotMemoryTest, AMistakeIsNoMemory) {
  Read();
  folder_.Write("robot.yaml", "sidestep_robot: 1\n");
  EXPECT_NE(folder_.ErrorOf([&] { Read(); }), "no error");
}

}  // namespace
}  // namespace sidestep::robot_memory_test
