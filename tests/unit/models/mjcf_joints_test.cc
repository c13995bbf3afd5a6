// SPDX-License-Identifier: BSD-3-Clause
// Servos of an MJCF's motors, and what is said of mistakes. The robot is a box biped; whether it
// could stand is not asked here.
#include "models/robot_description/mjcf_joints.h"

#include <gtest/gtest.h>

#include "tests/support/box_biped.h"

namespace sidestep::mjcf_joints_test {
namespace {

constexpr char kYaml[] =
    "sidestep_robot: 1\n"
    "name: box_biped\n"
    "mjcf: box_biped.xml\n"
    "base: pelvis\n"
    "imu: imu\n"
    "com_height_m: 0.47\n"
    "base_height_m: 0.43\n"
    "joints:\n"
    "  - names: [l_hip_roll, l_hip_pitch, l_knee, l_ankle_pitch, l_ankle_roll, r_hip_roll,\n"
    "            r_hip_pitch, r_knee, r_ankle_pitch, r_ankle_roll]\n"
    "    velocity_limit_radps: 10\n"
    "    servo_stiffness_Nm_per_rad: 4000\n"
    "    servo_damping_Nms_per_rad: 8\n"
    "  - {names: [waist, shoulder], velocity_limit_radps: 5, servo_stiffness_Nm_per_rad: 400, "
    "servo_damping_Nms_per_rad: 4, posture_weight: 2}\n"
    "feet:\n"
    "  - {name: left, frame: l_sole, force_torque: [l_front_ft, l_rear_ft], vertices_m: [[0, 0, "
    "0]]}\n"
    "  - {name: right, frame: r_sole, force_torque: [r_front_ft, r_rear_ft], vertices_m: [[0, 0, "
    "0]]}\n";

class MjcfJointsTest : public testing::Test {
 protected:
  RobotDescription Read(const std::string& yaml) const {
    folder_.Write("box_biped.xml", internal::BoxBipedMjcf());
    return ReadRobotDescription(folder_.Write("robot.yaml", yaml));
  }
  std::string ErrorOfEdit(const std::string& from, const std::string& to) const {
    return folder_.ErrorOf([&] { Read(Edit(kYaml, from, to)); });
  }

 private:
  TempFolder folder_;
};

TEST_F(MjcfJointsTest, ServosComeInTheOrderOfTheActuators) {
  const RobotDescription robot = Read(kYaml);
  ASSERT_EQ(robot.joints.size(), 12U);
  EXPECT_EQ(robot.joints[0].name, "shoulder") << "the MJCF's first, though the file's last";
  EXPECT_EQ(robot.joints[0].servo_stiffness_Nm_per_rad, 400.0);
  EXPECT_EQ(robot.joints[0].velocity_limit_radps, 5.0);
  EXPECT_EQ(robot.joints[0].posture_weight, 2.0);
  EXPECT_EQ(robot.joints[2].name, "l_hip_roll");
  EXPECT_EQ(robot.joints[2].servo_damping_Nms_per_rad, 8.0);
  EXPECT_EQ(robot.joints[2].posture_weight, 1.0);
}

TEST_F(MjcfJointsTest, EveryMotorNeedsOneServo) {
  EXPECT_EQ(ErrorOfEdit("names: [waist, shoulder]", "names: [waist]"),
            "robot.yaml:9:3: error: joints must name every joint with a motor, also 'shoulder'");
  EXPECT_EQ(ErrorOfEdit("names: [waist, shoulder]", "names: [waist, shoulder, l_knee]"),
            "robot.yaml:14:31: error: joints.1.names.2 = 'l_knee' is in two groups");
  EXPECT_EQ(ErrorOfEdit("names: [waist, shoulder]", "names: [waist, sholder]"),
            "robot.yaml:14:21: error: joints.1.names.1 = 'sholder' is no joint with a motor of the "
            "MJCF; did you mean 'shoulder'?");
}

TEST_F(MjcfJointsTest, WhatTheMjcfTellsIsRefused) {
  EXPECT_EQ(ErrorOfEdit("posture_weight: 2", "armature_kgm2: 0.1"),
            "robot.yaml:14:120: error: joints.1.armature_kgm2 is told by the MJCF; leave it out");
  EXPECT_EQ(ErrorOfEdit("velocity_limit_radps: 5, ", ""),
            "robot.yaml:14:5: error: joints.1.velocity_limit_radps is missing (required)");
}

}  // namespace
}  // namespace sidestep::mjcf_joints_test
