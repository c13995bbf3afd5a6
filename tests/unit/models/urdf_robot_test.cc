// SPDX-License-Identifier: BSD-3-Clause
// robot.yaml of a URDF: what is read, and what is said of mistakes.
#include <gtest/gtest.h>

#include "models/robot_description/robot_description.h"
#include "models/support/config_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::urdf_robot_test {
namespace {

using Names = std::vector<std::string>;

const std::filesystem::path kMini =
    std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/models/mini_urdf";

TEST(UrdfRobotTest, EveryKeyIsRead) {
  const RobotDescription robot = ReadRobotDescription(kMini / "robot.yaml");
  ASSERT_TRUE(robot.model);
  EXPECT_EQ(robot.model->language, ModelLanguage::kUrdf);
  EXPECT_EQ(robot.model->file, kMini / "mini.urdf");
  EXPECT_EQ(robot.base, "trunk");
  EXPECT_EQ(robot.imu, "imu");
  EXPECT_EQ(robot.torso, "imu");
  EXPECT_EQ(robot.base_rpy_rad, Eigen::Vector3d(0, 0.1, 0));
  EXPECT_EQ(robot.force_torque, (Names{"arm_ft", "foot_ft"}));
  EXPECT_EQ(robot.arm_force_torque, (Names{"arm_ft"}));
  ASSERT_EQ(robot.feet.size(), 1U);
  EXPECT_EQ(robot.feet[0].force_torque, (Names{"foot_ft"}));
}

TEST(UrdfRobotTest, JointsComeInTheOrderOfTheirGroups) {
  const RobotDescription robot = ReadRobotDescription(kMini / "robot.yaml");
  ASSERT_EQ(robot.joints.size(), 3U);
  EXPECT_EQ(robot.joints[0].name, "shoulder");
  EXPECT_EQ(robot.joints[0].velocity_limit_radps, 3.0) << "the URDF's";
  EXPECT_EQ(robot.joints[0].posture_weight, 1.0);
  EXPECT_EQ(robot.joints[1].name, "hip");
  EXPECT_EQ(robot.joints[1].servo_stiffness_Nm_per_rad, 100.0);
  EXPECT_EQ(robot.joints[1].servo_damping_Nms_per_rad, 5.0);
  EXPECT_EQ(robot.joints[2].name, "grip");
  EXPECT_EQ(robot.joints[2].velocity_limit_radps, 0.5) << "robot.yaml's";
  EXPECT_EQ(robot.joints[2].posture_weight, 3.0);
}

TEST(UrdfRobotTest, BodiesAndFramesAreThoseOfTheConvertedModel) {
  const RobotNames names = NamesIn(ReadRobotDescription(kMini / "robot.yaml"));
  EXPECT_EQ(names.bodies,
            (Names{"trunk", "leg", "foot", "arm", "arm_ft_distal", "gripper", "tail"}));
  EXPECT_EQ(names.frames, (Names{"footprint", "imu", "foot_ft", "sole", "arm_ft"}));
}

/// Copies of the fixture's robot.yaml, with one edit.
class UrdfRobotErrorTest : public testing::Test {
 protected:
  std::string ErrorOfEdit(const std::string& from, const std::string& to) const {
    folder_.Write("mini.urdf", ReadConfigText(kMini / "mini.urdf"));
    folder_.Write("robot.yaml", Edit(ReadConfigText(kMini / "robot.yaml"), from, to));
    return folder_.ErrorOf([&] { ReadRobotDescription(folder_.path() / "robot.yaml"); });
  }

  const TempFolder folder_;
};

TEST_F(UrdfRobotErrorTest, Files) {
  EXPECT_EQ(ErrorOfEdit("urdf: mini.urdf", "urdf: maxi.urdf"),
            "robot.yaml:3:7: error: urdf = 'maxi.urdf' is no file beside this one");
  EXPECT_EQ(ErrorOfEdit("urdf: mini.urdf", "urdf: mini.urdf\nmjcf: mini.xml"),
            "robot.yaml:4:1: error: mjcf can't be beside a urdf");
  EXPECT_EQ(ErrorOfEdit("base: trunk", "base: trunk\nmass_kg: 3"),
            "robot.yaml:5:10: error: mass_kg is told by the URDF; leave it out");
  EXPECT_EQ(ErrorOfEdit("base: trunk", "base: trunk\ncolour: red"),
            "robot.yaml:5:1: error: colour is not a known key; known keys: sidestep_robot, name, "
            "com_height_m, urdf, mjcf, mass_kg, locked, locked_joints, joints, feet, meshes, imu, "
            "force_torque, self_collision, base, torso, base_height_m, base_rpy_rad, home, "
            "arm_force_torque, control, control_torque");
}

TEST_F(UrdfRobotErrorTest, PartsOfTheUrdf) {
  EXPECT_EQ(ErrorOfEdit("base: trunk", "base: leg"),
            "robot.yaml:4:7: error: base = 'leg' is no base (first link with mass) of the URDF; "
            "known ones: trunk");
  EXPECT_EQ(ErrorOfEdit("imu: imu\n", "imu: imv\n"),
            "robot.yaml:5:6: error: imu = 'imv' is no link without mass of the URDF; did you mean "
            "'imu'?");
  EXPECT_EQ(ErrorOfEdit("torso: imu", "torso: trunk"),
            "robot.yaml:6:8: error: torso = 'trunk' is no link without mass of the URDF; known "
            "ones: footprint, imu, foot_ft, sole, arm_ft");
  EXPECT_EQ(
      ErrorOfEdit("home: {hip: -0.1}", "home: {wag: -0.1}"),
      "robot.yaml:10:8: error: home.wag is no joint of the URDF; known ones: hip, shoulder, grip");
  EXPECT_EQ(ErrorOfEdit("frame: sole", "frame: sool"),
            "robot.yaml:32:25: error: feet.0.frame = 'sool' is no link without mass of the URDF; "
            "known ones: footprint, imu, foot_ft, sole, arm_ft");
  EXPECT_EQ(ErrorOfEdit("base_rpy_rad: [0, 0.1, 0]", "base_rpy_rad: [0, 10, 0]"),
            "robot.yaml:9:19: error: base_rpy_rad.1 = 10 violates -6.283185307179586 <= "
            "base_rpy_rad.1 <= 6.283185307179586");
}

TEST_F(UrdfRobotErrorTest, Joints) {
  EXPECT_EQ(ErrorOfEdit("locked_joints: [wag]", "locked_joints: [wog]"),
            "robot.yaml:11:17: error: locked_joints.0 = 'wog' is no moving joint of the URDF; did "
            "you mean 'wag'?");
  EXPECT_EQ(
      ErrorOfEdit("locked_joints: [wag]\n", ""),
      "robot.yaml:12:3: error: joints must name 'wag', or locked_joints must (or locked: rest)");
  EXPECT_EQ(ErrorOfEdit("locked_joints: [wag]", "locked_joints: [wag, hip]"),
            "robot.yaml:13:24: error: joints.0.names.1 = 'hip' is no moving joint of the URDF; "
            "known ones: shoulder, grip");
  EXPECT_EQ(ErrorOfEdit("names: [grip]", "names: [grip, hip]"),
            "robot.yaml:14:19: error: joints.1.names.1 = 'hip' is in two groups");
  EXPECT_EQ(ErrorOfEdit("names: [grip]", "names: [grip, grip]"),
            "robot.yaml:14:19: error: joints.1.names.1 = 'grip' is there twice");
  EXPECT_EQ(ErrorOfEdit("names: [grip]", "names: []"),
            "robot.yaml:14:12: error: joints.1.names must hold at least one joint");
  EXPECT_EQ(ErrorOfEdit("    torque_limit_Nm: 8\n", ""),
            "robot.yaml:14:5: error: joints.1 needs torque_limit_Nm, because the URDF has none for "
            "'grip'");
  EXPECT_EQ(ErrorOfEdit("torque_limit_Nm: 8", "torque_limit_Nm: 0"),
            "robot.yaml:15:22: error: joints.1.torque_limit_Nm must be greater than 0");
  EXPECT_EQ(ErrorOfEdit("    servo_stiffness_Nm_per_rad: 50\n", ""),
            "robot.yaml:14:5: error: joints.1.servo_stiffness_Nm_per_rad is missing (required)");
  EXPECT_EQ(ErrorOfEdit("servo_damping_Nms_per_rad: 2\n", "servo_damping_Nms_per_rad: -2\n"),
            "robot.yaml:19:32: error: joints.1.servo_damping_Nms_per_rad = -2 violates 0 <= "
            "servo_damping_Nms_per_rad <= 1e+06");
  EXPECT_EQ(ErrorOfEdit("posture_weight: 3", "posture_wait: 3"),
            "robot.yaml:20:5: error: joints.1.posture_wait is not a known key; did you mean "
            "'posture_weight'?");
}

TEST_F(UrdfRobotErrorTest, LockedRest) {
  EXPECT_EQ(ErrorOfEdit("locked_joints: [wag]", "locked: rest"), "no error");
  EXPECT_EQ(ErrorOfEdit("locked_joints: [wag]", "locked: wag"),
            "robot.yaml:11:9: error: locked = 'wag' must be rest: every joint that no group of "
            "joints names");
  EXPECT_EQ(ErrorOfEdit("locked_joints: [wag]", "locked: rest\nlocked_joints: [wag]"),
            "robot.yaml:12:1: error: locked_joints can't be beside locked: rest");
}

TEST_F(UrdfRobotErrorTest, EveryJointWithoutAMotorIsNamedAtOnce) {
  EXPECT_EQ(ErrorOfEdit("names: [shoulder, hip]", "names: [shoulder]"),
            "robot.yaml:13:3: error: joints must name 'hip', or locked_joints must (or locked: "
            "rest)");
  folder_.Write("mini.urdf", ReadConfigText(kMini / "mini.urdf"));
  const std::string text = Edit(ReadConfigText(kMini / "robot.yaml"), "locked_joints: [wag]\n", "");
  folder_.Write("robot.yaml", Edit(text, "names: [shoulder, hip]", "names: [shoulder]"));
  EXPECT_EQ(folder_.ErrorOf([&] { ReadRobotDescription(folder_.path() / "robot.yaml"); }),
            "robot.yaml:12:3: error: joints must name 'hip', 'wag', or locked_joints must (or "
            "locked: rest)");
}

TEST(UrdfRobotTest, RestLocksWhatNoGroupNames) {
  const TempFolder folder;
  folder.Write("mini.urdf", ReadConfigText(kMini / "mini.urdf"));
  const std::string listed = ReadConfigText(kMini / "robot.yaml");
  const auto file =
      folder.Write("robot.yaml", Edit(listed, "locked_joints: [wag]", "locked: rest"));
  EXPECT_EQ(ReadRobotDescription(file).model->simulated_mjcf,
            ReadRobotDescription(kMini / "robot.yaml").model->simulated_mjcf);
}

TEST_F(UrdfRobotErrorTest, ForceTorque) {
  EXPECT_EQ(ErrorOfEdit("- name: arm_ft", "- name: arm_f"),
            "robot.yaml:22:11: error: force_torque.0.name = 'arm_f' is no link without mass of the "
            "URDF; did you mean 'arm_ft'?");
  EXPECT_EQ(ErrorOfEdit("- {name: foot_ft}", "- {name: arm_ft}"),
            "robot.yaml:29:12: error: force_torque.1.name = 'arm_ft' names two sensors");
  EXPECT_EQ(ErrorOfEdit("- {name: foot_ft}", "- {name: imu}"),
            "robot.yaml:29:5: error: force_torque.1 needs distal: its frame is on the base, which "
            "has no parent");
  EXPECT_EQ(ErrorOfEdit("mass_kg: 0.3", "mass_kg: 0.4"),
            "robot.yaml:24:16: error: force_torque.0.distal.mass_kg must be less than the 0.4 kg "
            "of link 'arm'");
  EXPECT_EQ(ErrorOfEdit("mass_kg: 0.3", "mass_kg: 0"),
            "robot.yaml:24:16: error: force_torque.0.distal.mass_kg must be greater than 0");
  EXPECT_EQ(
      ErrorOfEdit("[0.002, 0, 0, 0.002, 0, 0.001]", "[0.002, 0, 0, 0.002, 0, 0.01]"),
      "robot.yaml:26:21: error: force_torque.0.distal.inertia_kgm2 is an inertia that no body has");
  EXPECT_EQ(ErrorOfEdit("[0.002, 0, 0, 0.002, 0, 0.001]", "[0.004, 0, 0, 0.004, 0, 0.002]"),
            "robot.yaml:26:21: error: force_torque.0.distal.inertia_kgm2 leaves link 'arm' an "
            "inertia that no body has");
  EXPECT_EQ(ErrorOfEdit("[0.002, 0, 0, 0.002, 0, 0.001]", "[0.002, 0, 0.001]"),
            "robot.yaml:26:21: error: force_torque.0.distal.inertia_kgm2 must be a list of 6 "
            "numbers, not of 3");
  EXPECT_EQ(ErrorOfEdit("joints: [grip]\n", "joints: [hip]\n"),
            "robot.yaml:27:16: error: force_torque.0.distal.joints.0 = 'hip' is no joint of link "
            "'arm' of the URDF; known ones: grip");
  EXPECT_EQ(ErrorOfEdit("shapes: [sleeve]", "shapes: [sleave]"),
            "robot.yaml:28:16: error: force_torque.0.distal.shapes.0 = 'sleave' is no shape of "
            "link 'arm' of the URDF; did you mean 'sleeve'?");
  EXPECT_EQ(ErrorOfEdit("arm_force_torque: [arm_ft]", "arm_force_torque: [imu]"),
            "robot.yaml:30:20: error: arm_force_torque.0 needs a sensor 'imu_force', which the "
            "URDF lacks");
  EXPECT_EQ(ErrorOfEdit("force_torque: [foot_ft], ", ""),
            "robot.yaml:32:5: error: feet.0.force_torque is missing (required)");
  EXPECT_EQ(ErrorOfEdit("force_torque: [foot_ft]", "force_torque: []"),
            "robot.yaml:32:45: error: feet.0.force_torque must hold at least one sensor");
}

TEST_F(UrdfRobotErrorTest, SelfCollision) {
  EXPECT_EQ(ErrorOfEdit("[[arm], [leg, foot]]", "[[arm], [leg, fot]]"),
            "robot.yaml:34:19: error: self_collision.0.1.1 = 'fot' is no link of the URDF; did you "
            "mean 'foot'?");
  EXPECT_EQ(ErrorOfEdit("[[arm], [leg, foot]]", "[[arm, leg, foot]]"),
            "robot.yaml:34:5: error: self_collision.0 must be two lists of links");
}

}  // namespace
}  // namespace sidestep::urdf_robot_test
