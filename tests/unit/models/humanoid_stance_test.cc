// SPDX-License-Identifier: BSD-3-Clause
// What every humanoid that ships must do: stand at home, feel its weight, know when it touches.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/models/robot_on_floor.h"

namespace sidestep::humanoid_stance_test {
namespace {

constexpr double kGravity_mps2 = 9.81;

RobotDescription Read(const std::string& name) {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models" / name /
                              "robot.yaml");
}

class HumanoidStanceTest : public testing::TestWithParam<std::string> {
 protected:
  const RobotDescription robot_{Read(GetParam())};
  RobotOnFloor stage_{robot_};
};

TEST_P(HumanoidStanceTest, AtHomeTheFeetAreFlatOnTheFloor) {
  for (const FootDescription& foot : robot_.feet) {
    const int site = stage_.Site(foot.frame);
    EXPECT_NEAR(stage_.data().site_xpos[3 * site + 2], 0.0, 1e-4) << foot.name;
    EXPECT_NEAR(stage_.data().site_xmat[9 * site + 8], 1.0, 1e-8) << foot.name;
    EXPECT_NEAR(stage_.data().site_xmat[9 * site], 1.0, 1e-8) << foot.name << " looks aside";
  }
}

TEST_P(HumanoidStanceTest, AtHomeTheComIsOverTheMidpointOfTheFeet) {
  EXPECT_LT(stage_.Com_W().head<2>().norm(), 1e-3);
  EXPECT_NEAR(stage_.Com_W().z(), robot_.com_height_m, 1e-3);
}

TEST_P(HumanoidStanceTest, AtHomeNothingTouchesButTheFeet) {
  stage_.data().qpos[2] -= 1e-3;  // pressed in, so that every part of the feet touches
  mj_forward(&stage_.model(), &stage_.data());
  std::set<ContactPair> expected;
  for (const FootDescription& foot : robot_.feet) {
    for (const std::string& sensor : foot.force_torque) {
      const int body = stage_.model().site_bodyid[stage_.Site(sensor)];
      expected.insert({mj_id2name(&stage_.model(), mjOBJ_BODY, body), "world"});
    }
  }
  EXPECT_EQ(stage_.Contacts(), expected);
}

TEST_P(HumanoidStanceTest, StandingTheFeetFeelTheWeightAboveThem) {
  stage_.Stand(1500);
  ASSERT_NEAR(stage_.Com_W().z(), robot_.com_height_m, 0.01) << "fell";
  Eigen::Vector3d sum_W = Eigen::Vector3d::Zero();
  double below_kg = 0.0;
  for (const FootDescription& foot : robot_.feet) {
    for (const std::string& sensor : foot.force_torque) {
      sum_W += stage_.SensorForce_W(sensor);
      below_kg += stage_.model().body_mass[stage_.model().site_bodyid[stage_.Site(sensor)]];
    }
  }
  const double weight_N = (mj_getTotalmass(&stage_.model()) - below_kg) * kGravity_mps2;
  // MuJoCo's sign: what the proximal part does to the distal one, here downwards.
  EXPECT_NEAR(sum_W.z(), -weight_N, 0.005 * weight_N);  // it still sways a little
  EXPECT_NE(sum_W.z(), -weight_N) << "suspicious: is the weight itself read?";
}

TEST_P(HumanoidStanceTest, StandingWearsOutNoJointLimit) {
  stage_.Stand(1500);
  for (int i = 0; i < stage_.model().nu; ++i) {
    const int joint = stage_.model().actuator_trnid[2 * i];
    const double position = stage_.data().qpos[stage_.model().jnt_qposadr[joint]];
    EXPECT_GT(position, stage_.model().jnt_range[2 * joint])
        << mj_id2name(&stage_.model(), mjOBJ_JOINT, joint);
    EXPECT_LT(position, stage_.model().jnt_range[2 * joint + 1]);
    EXPECT_LT(std::abs(stage_.data().ctrl[i]), 0.7 * stage_.model().actuator_ctrlrange[2 * i + 1]);
  }
}

TEST_P(HumanoidStanceTest, AFallenRobotLiesOnTheFloorByItsBody) {
  const double lying[4] = {0.7071067811865476, 0, 0.7071067811865476, 0};
  mju_copy4(stage_.data().qpos + 3, lying);
  stage_.data().qpos[2] = 0.1;
  mj_forward(&stage_.model(), &stage_.data());
  int num_others = 0;
  for (const auto& [body, other] : stage_.Contacts()) {
    if (other == "world" && body.find("foot") == std::string::npos) ++num_others;
  }
  EXPECT_GT(num_others, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, HumanoidStanceTest,
                         testing::Values(std::string("icub3"), std::string("generic_humanoid"),
                                         std::string("g1"), std::string("xbot_l")),
                         [](const auto& name) { return name.param; });

/// Presses one body of a standing robot and tells how the reading of a sensor changes.
Eigen::Vector3d ChangeUnderPush(const RobotDescription& robot, const std::string& body,
                                const std::string& sensor, const Eigen::Vector3d& push_W_N) {
  RobotOnFloor stage(robot);
  stage.Stand(1500);
  const Eigen::Vector3d before = stage.SensorForce_W(sensor);
  mju_copy3(stage.data().xfrc_applied + 6 * stage.Body(body), push_W_N.data());
  stage.Stand(1000);
  return stage.SensorForce_W(sensor) - before;
}

TEST(Icub3StanceTest, AnArmSensorFeelsAPushAtTheHandAndOnlyItsOwn) {
  const RobotDescription robot = Read("icub3");
  const Eigen::Vector3d push_W_N(3, 10, -4);
  // MuJoCo tells what the proximal part does, which is to withstand. 0.5 N: the robot still sways.
  EXPECT_LT((ChangeUnderPush(robot, "l_elbow_1", "l_arm_ft", push_W_N) + push_W_N).norm(), 0.5);
  EXPECT_LT(ChangeUnderPush(robot, "l_elbow_1", "r_arm_ft", push_W_N).norm(), 0.5);
}

TEST(Icub3StanceTest, TheFeetShareTheWeightAboutEqually) {
  // Compliant servos: with stiff ones the soles' moments share the weight as they please.
  RobotDescription robot = Read("icub3");
  for (JointDescription& joint : robot.joints) joint.servo_stiffness_Nm_per_rad = 2300.0;
  RobotOnFloor stage(robot);
  stage.Stand(1500);
  const double left_N =
      stage.SensorForce_W("l_foot_front_ft").z() + stage.SensorForce_W("l_foot_rear_ft").z();
  const double right_N =
      stage.SensorForce_W("r_foot_front_ft").z() + stage.SensorForce_W("r_foot_rear_ft").z();
  EXPECT_NEAR(left_N / right_N, 1.0, 0.03);
}

TEST(Icub3StanceTest, KneesThatMeetAreAContactOfTheRobotWithItself) {
  RobotOnFloor stage(Read("icub3"));
  for (const char* side : {"l_", "r_"}) stage.SetJoint(std::string(side) + "hip_roll", -0.15);
  mj_forward(&stage.model(), &stage.data());
  EXPECT_TRUE(stage.Contacts().contains({"l_lower_leg", "r_lower_leg"}));
}

TEST(Icub3StanceTest, AnArmThatMeetsTheTrunkIsAContactOfTheRobotWithItself) {
  RobotOnFloor stage(Read("icub3"));
  stage.SetJoint("r_shoulder_roll", 0.21);  // its least
  stage.SetJoint("r_shoulder_pitch", -0.5);
  stage.SetJoint("r_shoulder_yaw", 1.39);
  stage.SetJoint("r_elbow", 1.3);
  mj_forward(&stage.model(), &stage.data());
  EXPECT_TRUE(stage.Contacts().contains({"chest", "r_elbow_1"}));
}

}  // namespace
}  // namespace sidestep::humanoid_stance_test
