// SPDX-License-Identifier: BSD-3-Clause
// What is said of robots that start wrongly. Each edit is one that users make; the robots that ship
// are the negative control.
#include "models/robot_description/robot_faults.h"

#include <gtest/gtest.h>

#include "models/support/config_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::robot_faults_test {
namespace {

const std::filesystem::path kShipped = std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models";

TEST(RobotFaultsTest, RobotsThatShipHaveNone) {
  for (const char* name : {"hopper", "rabbit", "biped", "icub3", "generic_humanoid", "g1", "xbot_l",
                           "one_leg", "two_legs"}) {
    EXPECT_NO_THROW(ReadSoundRobot(kShipped / name / "robot.yaml")) << name;
  }
}

/// Copies of the generic humanoid, with edits.
class HumanoidFaultsTest : public testing::Test {
 protected:
  void EditYaml(const std::string& from, const std::string& to) { yaml_ = Edit(yaml_, from, to); }
  void EditUrdf(const std::string& from, const std::string& to) { urdf_ = Edit(urdf_, from, to); }
  std::string Error() const {
    folder_.Write("generic_humanoid.urdf", urdf_);
    folder_.Write("r.yaml", yaml_);
    return folder_.ErrorOf([&] { ReadSoundRobot(folder_.path() / "r.yaml"); });
  }
  std::string ErrorOfYaml(const std::string& from, const std::string& to) {
    EditYaml(from, to);
    return Error();
  }

 private:
  TempFolder folder_;
  std::string yaml_{ReadConfigText(kShipped / "generic_humanoid/robot.yaml")};
  std::string urdf_{ReadConfigText(kShipped / "generic_humanoid/generic_humanoid.urdf")};
};

constexpr char kLeftSole[] = "<child link=\"left_sole\"/><origin xyz=\"0.03 0 -0.04\"/>";

TEST_F(HumanoidFaultsTest, TheRobotItselfIsSound) { EXPECT_EQ(Error(), "no error"); }

TEST_F(HumanoidFaultsTest, BaseTooLow) {
  EXPECT_EQ(ErrorOfYaml("base_height_m: 0.811120901320", "base_height_m: 0.79"),
            "r.yaml:11:16: error: base_height_m = 0.79 puts the soles 0.02112 m into the floor at "
            "the start; 0.8111 puts them on it");
}

TEST_F(HumanoidFaultsTest, BaseTooHigh) {
  EXPECT_EQ(
      ErrorOfYaml("base_height_m: 0.811120901320", "base_height_m: 0.816"),
      "r.yaml:11:16: error: base_height_m = 0.816 puts the soles 0.00488 m above the floor at "
      "the start; 0.8111 puts them on it");
}

TEST_F(HumanoidFaultsTest, FiguresOfThreeDecimalsAreGoodEnough) {
  EditYaml("base_height_m: 0.811120901320", "base_height_m: 0.812");
  EditYaml("com_height_m: 0.8149", "com_height_m: 0.81");
  EXPECT_EQ(Error(), "no error");
}

TEST_F(HumanoidFaultsTest, ComHeight) {
  EXPECT_EQ(
      ErrorOfYaml("com_height_m: 0.8149", "com_height_m: 0.7"),
      "r.yaml:8:15: error: com_height_m = 0.7 is 0.1149 m below the CoM at the start, which is "
      "0.8149 m above the soles");
}

TEST_F(HumanoidFaultsTest, AllFaultsAreToldAtOnceALineEach) {
  EditYaml("com_height_m: 0.8149", "com_height_m: 0.9");
  EditYaml("  left_ankle_pitch: -0.425308470915\n", "");
  EditYaml("  left_elbow: -0.5\n", "  left_elbow: 0.5\n");
  EXPECT_EQ(
      Error(),
      "r.yaml:8:15: error: com_height_m = 0.9 is 0.08279 m above the CoM at the start, which "
      "is 0.8172 m above the soles\n"
      "r.yaml:17:15: error: home.left_elbow = 0.5 is 0.5 rad outside the joint's range of -2.3 "
      "to 0\n"
      "r.yaml:13:3: error: home tilts the sole of foot 'left' by 0.4253 rad at the start; it "
      "must be level (within 0.02)\n"
      "r.yaml:13:3: error: home puts foot 'right' 0.00391 m higher than 'left' at the start");
}

TEST_F(HumanoidFaultsTest, LevellingSolesMovesThemSoThatTheBasesHeightIsNotBlamed) {
  EditYaml("  left_ankle_pitch: -0.425308470915\n", "");
  EditYaml("  right_ankle_pitch: -0.425308470915\n", "");
  EXPECT_EQ(Error().find("base_height_m"), std::string::npos) << Error();
  EditYaml("base_height_m: 0.811120901320", "base_height_m: 0.7");
  EXPECT_NE(Error().find("base_height_m"), std::string::npos) << "too low by any tilt";
}

TEST_F(HumanoidFaultsTest, AJointThatHomeDoesNotNameStartsAtZero) {
  EditUrdf(
      "<parent link=\"pelvis\"/><child link=\"trunk\"/><origin xyz=\"0 0 0.12\"/><axis xyz=\"0 "
      "0 1\"/>\n    <limit lower=\"-1.2\"",
      "<parent link=\"pelvis\"/><child link=\"trunk\"/><origin xyz=\"0 0 0.12\"/><axis xyz=\"0 "
      "0 1\"/>\n    <limit lower=\"0.2\"");
  EXPECT_EQ(Error(),
            "r.yaml:13:3: error: home.waist_yaw = 0 is 0.2 rad outside the joint's range of "
            "0.2 to 1.2");
}

TEST_F(HumanoidFaultsTest, LeftAndRightSwapped) {
  EditYaml("name: left\n    frame: left_sole\n    force_torque: [left_foot_ft]",
           "name: left\n    frame: right_sole_\n    force_torque: [right_foot_ft]");
  EditYaml("name: right\n    frame: right_sole\n    force_torque: [right_foot_ft]",
           "name: right\n    frame: left_sole\n    force_torque: [left_foot_ft]");
  EditYaml("right_sole_", "right_sole");
  EXPECT_EQ(Error(),
            "r.yaml:58:3: error: feet must be in the order left, right: at the start the "
            "first one, 'left', is 0.19 m to the right of 'right'");
}

TEST_F(HumanoidFaultsTest, ASoleThatFacesBackwards) {
  EditUrdf(kLeftSole,
           "<child link=\"left_sole\"/><origin xyz=\"0.03 0 -0.04\" rpy=\"0 0 3.1416\"/>");
  EXPECT_EQ(Error(),
            "r.yaml:59:12: error: feet.0.frame = 'left_sole' has its x axis turned by "
            "-3.142 rad from the world's at the start: it points backwards; it must point "
            "to the toes, to the front (at most 0.5)");
}

TEST_F(HumanoidFaultsTest, ASoleWhoseZPointsToTheToes) {
  EditUrdf(kLeftSole,
           "<child link=\"left_sole\"/><origin xyz=\"0.03 0 -0.04\" rpy=\"0 1.5708 0\"/>");
  EXPECT_NE(Error().find("feet.0.frame = 'left_sole' has its z axis 1.571 rad from upwards at the "
                         "start; it must point up"),
            std::string::npos);
}

TEST_F(HumanoidFaultsTest, CornersOutsideTheFootsShape) {
  EditYaml("force_torque: [left_foot_ft]\n    vertices_m: [[0.10, 0.045, 0]",
           "force_torque: [left_foot_ft]\n    vertices_m: [[0.13, 0.045, 0]");
  EXPECT_EQ(Error(),
            "r.yaml:61:18: error: feet.0.vertices_m.0 is 0.015 m outside the foot's "
            "collision shape, where the ground can't carry it");
}

TEST_F(HumanoidFaultsTest, ASoleFrameAboveTheFootsShape) {
  EditUrdf(kLeftSole, "<child link=\"left_sole\"/><origin xyz=\"0.03 0 -0.03\"/>");
  EXPECT_NE(
      Error().find("feet.0.frame = 'left_sole': its vertices are 0.01 m above the lowest point "
                   "of the foot's collision shape"),
      std::string::npos);
}

TEST_F(HumanoidFaultsTest, AFootWithoutAShape) {
  EditUrdf(
      "    <collision><origin xyz=\"0.03 0 -0.025\"/><geometry><box size=\"0.23 0.11 "
      "0.03\"/></geometry></collision>\n  </link>\n  <joint name=\"left_foot_mount\"",
      "  </link>\n  <joint name=\"left_foot_mount\"");
  EXPECT_EQ(Error(),
            "r.yaml:59:12: error: feet.0.frame = 'left_sole' is on 'left_foot', which has "
            "no collision shape to stand on");
}

TEST_F(HumanoidFaultsTest, ALegOfFiveJoints) {
  EditYaml("left_ankle_pitch, left_ankle_roll,", "left_ankle_pitch,");
  EditYaml("# Limits of torque", "locked_joints: [left_ankle_roll]\n# Limits of torque");
  EXPECT_EQ(Error(),
            "r.yaml:60:12: error: feet.0.frame = 'left_sole' is at the end of a leg with 5 joints, "
            "counted from 'pelvis', that moves it in 5 ways: a flat sole has six coordinates to be "
            "held, so that a leg needs six joints");
}

TEST_F(HumanoidFaultsTest, SixJointsOfWhichTwoDoTheSameAreNoSix) {
  EditUrdf(
      "<parent link=\"left_hip_yaw_link\"/><child link=\"left_hip_roll_link\"/><origin xyz=\"0 0 "
      "-0.06\"/><axis xyz=\"1 0 0\"/>",
      "<parent link=\"left_hip_yaw_link\"/><child link=\"left_hip_roll_link\"/><origin xyz=\"0 0 "
      "-0.06\"/><axis xyz=\"0 0 1\"/>");
  EXPECT_NE(Error().find("with 6 joints, counted from 'pelvis', that moves it in 5 ways"),
            std::string::npos);
}

TEST_F(HumanoidFaultsTest, TwoSensorsAtOneCut) {
  EditUrdf(
      "</robot>",
      "<link name=\"front_ft\"/><joint name=\"front_ft\" type=\"fixed\"><parent "
      "link=\"left_foot\"/><child link=\"front_ft\"/><origin xyz=\"0.06 0 0\"/></joint>\n</robot>");
  EditYaml("  - {name: left_foot_ft}\n", "  - {name: left_foot_ft}\n  - {name: front_ft}\n");
  EditYaml("force_torque: [left_foot_ft]", "force_torque: [left_foot_ft, front_ft]");
  EXPECT_EQ(
      Error(),
      "r.yaml:61:34: error: feet.0.force_torque.1 = 'front_ft' measures the same cut as "
      "'left_foot_ft', between 'left_foot' and its parent 'left_foot_bracket'; their sum would "
      "count it twice");
}

TEST_F(HumanoidFaultsTest, ASensorBelowAnother) {
  EditUrdf("</robot>",
           "<link name=\"ankle_ft\"/><joint name=\"ankle_ft\" type=\"fixed\"><parent "
           "link=\"left_ankle\"/><child link=\"ankle_ft\"/></joint>\n</robot>");
  EditYaml("  - {name: left_foot_ft}\n", "  - {name: left_foot_ft}\n  - {name: ankle_ft}\n");
  EditYaml("force_torque: [left_foot_ft]", "force_torque: [left_foot_ft, ankle_ft]");
  EXPECT_EQ(
      Error(),
      "r.yaml:61:34: error: feet.0.force_torque.1 = 'ankle_ft' and 'left_foot_ft' measure the "
      "same force: 'left_foot' hangs on 'left_ankle', which 'ankle_ft' feels whole; their sum "
      "would count it twice");
}

TEST_F(HumanoidFaultsTest, TheComBesideTheSoles) {
  for (const std::string side : {"left", "right"}) {
    EditYaml("  " + side + "_hip_pitch: -0.374691529085",
             "  " + side + "_hip_pitch: -0.674691529085");
    EditYaml("  " + side + "_ankle_pitch: -0.425308470915",
             "  " + side + "_ankle_pitch: -0.125308470915");
  }
  EXPECT_NE(Error().find("home puts the CoM "), std::string::npos) << Error();
}

}  // namespace
}  // namespace sidestep::robot_faults_test
