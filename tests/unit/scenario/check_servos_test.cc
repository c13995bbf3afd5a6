// SPDX-License-Identifier: BSD-3-Clause
// Servos too hard for the world's steps are refused, those too weak for the robot warned of. The
// robot is the generic humanoid, whose own gains are the negative control.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "models/support/config_text.h"
#include "sim/scenario/read_scenario.h"
#include "tests/support/temp_folder.h"

namespace sidestep::check_servos_test {
namespace {

class CheckServosTest : public testing::Test {
 protected:
  CheckServosTest() {
    folder_.Write("generic_humanoid.urdf", ReadConfigText(kShipped / "generic_humanoid.urdf"));
    Write(ReadConfigText(kShipped / "robot.yaml"));
    folder_.Write("a.yaml", "sidestep: 1\nname: a\nrobot: robot.yaml\nduration_s: 1\n");
  }
  void Write(const std::string& yaml) { folder_.Write("robot.yaml", yaml); }
  void EditRobot(const std::string& from, const std::string& to) {
    Write(Edit(ReadConfigText(folder_.path() / "robot.yaml"), from, to));
  }
  /// The error of reading the scenario, and all notes before it.
  std::string Error(const std::vector<std::string>& overrides) {
    notes_.clear();
    return folder_.ErrorOf([&] {
      ReadScenario(folder_.path() / "a.yaml", overrides,
                   [&](const std::string& note) { notes_.push_back(folder_.Shorten(note)); });
    });
  }

  std::vector<std::string> notes_;

 private:
  const std::filesystem::path kShipped =
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models/generic_humanoid";
  TempFolder folder_;
};

TEST_F(CheckServosTest, ServosThatShipAreFine) {
  EXPECT_EQ(Error({}), "no error");
  EXPECT_TRUE(notes_.empty());
}

TEST_F(CheckServosTest, DampingTimesStepAboveTheInertiaIsRefused) {
  const std::string error = Error({"world.step_s=0.005"});
  EXPECT_EQ(error.find("--set world.step_s=0.005: error: world.step_s = 0.005 is too long for '"),
            0U)
      << error;
  EXPECT_NE(error.find("servo damping x step = 0.15 must stay below the armature, 0.06 kg m^2"),
            std::string::npos)
      << error;
  EXPECT_EQ(Error({"world.step_s=0.005", "control.mode=torque", "control.rate_hz=200"}), "no error")
      << "nothing moves the servos there";
}

TEST_F(CheckServosTest, StiffnessAloneCanBeTooMuch) {
  EditRobot("servo_stiffness_Nm_per_rad: 12000\n    servo_damping_Nms_per_rad: 30",
            "servo_stiffness_Nm_per_rad: 260000\n    servo_damping_Nms_per_rad: 1");
  const std::string error = Error({});
  EXPECT_EQ(error.find("a.yaml:3:8: error: world.step_s = 0.001 is too long for '"), 0U) << error;
  EXPECT_NE(error.find("2 x servo damping x step + stiffness x step^2 = 0.262 must stay below four "
                       "times the inertia that the joint moves"),
            std::string::npos)
      << error;
}

TEST_F(CheckServosTest, WeakLegsAreToldOfAtTheirPlaceInTheRobotsFile) {
  EditRobot("servo_stiffness_Nm_per_rad: 12000", "servo_stiffness_Nm_per_rad: 300");
  EXPECT_EQ(Error({}), "no error");
  ASSERT_EQ(notes_.size(), 1U);
  EXPECT_EQ(notes_[0].find("robot.yaml:28:3: warning: servo_stiffness_Nm_per_rad of '"), 0U)
      << notes_[0];
  EXPECT_EQ(Error({"control.mode=torque"}), "no error");
  EXPECT_TRUE(notes_.empty());
}

}  // namespace
}  // namespace sidestep::check_servos_test
