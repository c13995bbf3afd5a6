// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/choose_motors.h"

#include "models/import/choose_gait.h"
#include "tests/support/maker_mjcf.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

std::vector<MotorGroup> MotorsOf(const MakerRobot& maker, double gravity_Nm, SourceRobot* robot) {
  *robot = SourceOf(maker);
  Notes notes;
  const BodyPlan plan = FindBodyPlan(*robot, "robot.urdf", &notes);
  return ChooseMotors(plan, gravity_Nm, 3.5, robot, &notes);
}

constexpr double kStep_s = 0.001;

TEST(ChooseMotors, StiffnessGrowsWithGravityAndDampingStaysUnderTheArmature) {
  SourceRobot robot;
  const auto heavy = MotorsOf(MakerRobot(), 480.0, &robot);
  const auto light = MotorsOf(MakerRobot(), 48.0, &robot);
  ASSERT_EQ(heavy.size(), 3U);  // legs, torso, arms
  for (std::size_t i = 0; i < heavy.size(); ++i) {
    EXPECT_NEAR(heavy[i].stiffness_Nm_per_rad, 10.0 * light[i].stiffness_Nm_per_rad, 1e-9);
    EXPECT_LE(heavy[i].damping_Nms_per_rad * kStep_s, 0.5 * heavy[i].armature_kgm2 * 1.001);
    EXPECT_LT(heavy[i].stiffness_Nm_per_rad * kStep_s * kStep_s, 0.5 * heavy[i].armature_kgm2);
  }
  EXPECT_GT(heavy[0].stiffness_Nm_per_rad, 10.0 * 480.0);
}

TEST(ChooseMotors, KeepsLimitsThatAMotorCanHave) {
  SourceRobot robot;
  MotorsOf(MakerRobot(), 480.0, &robot);
  const SourceJoint& knee = robot.joints[static_cast<std::size_t>(JointCalled(robot, "left_knee"))];
  EXPECT_EQ(knee.effort_Nm, 180.0);
  EXPECT_EQ(knee.velocity_radps, 12.0);
  EXPECT_TRUE(knee.note.empty());
}

TEST(ChooseMotors, ReplacesLimitsThatNoMotorHas) {
  MakerRobot maker;
  maker.has_wild_limits = true;
  SourceRobot robot;
  MotorsOf(maker, 480.0, &robot);
  const SourceJoint& knee = robot.joints[static_cast<std::size_t>(JointCalled(robot, "left_knee"))];
  EXPECT_NEAR(knee.effort_Nm, 240.0, 1e-9);
  EXPECT_EQ(knee.velocity_radps, 12.0);
  EXPECT_EQ(knee.note,
            "effort was 1000000000: chosen from the robot's weight; velocity was 0: chosen");
}

std::vector<MotorGroup> MotorsOf(const MakerMjcf& maker, double gravity_Nm, Notes* notes) {
  SourceRobot robot = SourceOfMjcf(RobotMjcf(maker));
  const BodyPlan plan = FindBodyPlan(robot, "robot.xml", notes);
  return ChooseMotors(plan, gravity_Nm, 3.5, &robot, notes);
}

TEST(ChooseMotors, KeepsTheRotorsOfAnMjcfAndDampsWhatTheyBear) {
  Notes notes;
  for (const MotorGroup& group : MotorsOf(MakerMjcf(), 1000.0, &notes)) {
    EXPECT_EQ(group.armature_kgm2, 0.04) << group.name;
    EXPECT_EQ(group.joint_damping_Nms_per_rad, 0.0) << "the joints' own";
    EXPECT_LE(group.damping_Nms_per_rad, 0.5 * 0.04 / kStep_s);
    EXPECT_LE(group.stiffness_Nm_per_rad, 1.5 * 0.04 / (kStep_s * kStep_s));
  }
}

TEST(ChooseMotors, TakesTheServosOfAnMjcfThatCarryTheRobot) {
  MakerMjcf maker;
  maker.actuators = MjcfActuators::kGenerals;
  Notes stiff;
  const MotorGroup legs = MotorsOf(maker, 400.0, &stiff)[0];
  EXPECT_EQ(legs.stiffness_Nm_per_rad, 9000.0);
  EXPECT_EQ(legs.damping_Nms_per_rad, 18.0);
  EXPECT_TRUE(HasNote(stiff, "took the servos of the MJCF's position actuators"));
  Notes soft;  // 9000 Nm/rad are 2.25 m g h
  EXPECT_EQ(MotorsOf(maker, 4000.0, &soft)[0].stiffness_Nm_per_rad, 60000.0) << "a step's most";
  EXPECT_TRUE(HasNote(soft,
                      "chose stiffer servos than the MJCF's position actuators, whose 9000 "
                      "Nm/rad are less than 3 m g h (12000 Nm/rad)"));
}

TEST(ChooseMotors, JointsWithOtherFiguresAreGroupsOfTheirOwn) {
  std::string mjcf = RobotMjcf(MakerMjcf());
  const std::string knee = "<joint name=\"left_knee\"";
  SourceRobot robot = SourceOfMjcf(Edit(mjcf, knee, knee + " armature=\"0.09\""));
  Notes notes;
  const BodyPlan plan = FindBodyPlan(robot, "robot.xml", &notes);
  const std::vector<MotorGroup> groups = ChooseMotors(plan, 400.0, 3.5, &robot, &notes);
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[1].joints, std::vector<int>{JointCalled(robot, "left_knee")});
  EXPECT_EQ(groups[1].name, "legs");
}

TEST(ChooseGait, IsTheSameWalkAtEverySize) {
  StartPose big, small;
  big.com_height_m = 0.8;
  big.leg_length_m = 0.7;
  small.com_height_m = 0.2;
  small.leg_length_m = 0.175;
  const Gait wide = ChooseGait(big, false), narrow = ChooseGait(small, false);
  EXPECT_NEAR(wide.omega_radps * 2.0, narrow.omega_radps, 1e-9);
  EXPECT_NEAR(wide.step_length_m, 4.0 * narrow.step_length_m, 0.002);
  EXPECT_NEAR(wide.swing_s, 2.0 * narrow.swing_s, 0.05);  // whole knots
  EXPECT_NEAR(wide.swing_height_m, 4.0 * narrow.swing_height_m, 0.002);
}

TEST(ChooseControl, GenericHumanoidKeepsItsOwn) {
  const ControlFigures figures = ChooseControl(60.0, 0.8149);
  EXPECT_DOUBLE_EQ(figures.com_weight, 2000.0);
  EXPECT_DOUBLE_EQ(figures.momentum_weight, 5000.0);
  EXPECT_DOUBLE_EQ(figures.contact_threshold_N, 25.0);
  EXPECT_DOUBLE_EQ(ChooseControl(6.0, 0.8149).contact_threshold_N, 2.5);
}

TEST(ChooseControl, FeetGiveWayToALoadAsQuicklyAtEverySize) {
  const ControlFigures big = ChooseControl(60.0, 0.8), small = ChooseControl(6.0, 0.2);
  const double stiffness = 6.0 / 0.2 / (60.0 / 0.8);  // of a leg, by m g / h
  EXPECT_NEAR(small.foot_load_compliance_mps_per_N * stiffness / big.foot_load_compliance_mps_per_N,
              1.0, 0.01);
}

TEST(ChooseMotors, ChoosesArmaturesThatBearNoServo) {
  Notes notes;
  MakerMjcf maker;
  maker.armature_kgm2 = 1e-4;  // without the square of the gear's ratio
  for (const MotorGroup& group : MotorsOf(maker, 400.0, &notes)) {
    EXPECT_GE(group.armature_kgm2, 0.025) << group.name;
    EXPECT_GT(group.stiffness_Nm_per_rad, (group.name == "arms" ? 0.8 : 20.0) * 400.0);
  }
  EXPECT_TRUE(HasNote(notes, "chose the armatures of 'left_hip_yaw', 'left_hip_roll'"));
}

TEST(ChooseMotors, DampsHeavierRotorsByTheirRoot) {
  Notes notes;
  MakerMjcf maker;
  maker.armature_kgm2 = 0.05;  // what 400 Nm choose
  const double light = MotorsOf(maker, 400.0, &notes)[0].damping_Nms_per_rad;
  maker.armature_kgm2 = 100 * 0.05;
  const double heavy = MotorsOf(maker, 400.0, &notes)[0].damping_Nms_per_rad;
  EXPECT_DOUBLE_EQ(light, 25.0);
  EXPECT_DOUBLE_EQ(heavy, 250.0);
}

TEST(ChooseGait, SlowsDownByWholeKnots) {
  Gait gait;
  gait.swing_s = 0.2;
  EXPECT_FALSE(SlowDown(0.19, &gait));
  EXPECT_EQ(gait.swing_s, 0.2);
  EXPECT_TRUE(SlowDown(0.26, &gait));
  EXPECT_NEAR(gait.swing_s, 0.3, 1e-12);
}

}  // namespace
}  // namespace sidestep::importer
