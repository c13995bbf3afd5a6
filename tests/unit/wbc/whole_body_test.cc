// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/whole_body.h"

#include <gtest/gtest.h>

namespace sidestep::wbc::whole_body_test {
namespace {

/// Two feet of four vertices; the left one is meant to stand and pushes.
std::vector<FootTarget> TwoFeet() {
  std::vector<FootTarget> feet(2);
  for (FootTarget& foot : feet) foot.vertex_force_N.setZero(3, 4);
  feet[0].planned_contact = true;
  feet[0].p_WF = {0.1, 0.2, 0.0};
  feet[0].vertex_force_N.row(2) << 1.0, 2.0, 3.0, 4.0;
  feet[1].p_WF = {0.3, -0.2, 0.05};
  return feet;
}

TEST(WholeBodyTest, PassiveCommandsZeroTorqueWhateverIsAsked) {
  RobotState state;
  state.joint_position.setOnes(3);
  ComTarget com;
  com.a_WC.setConstant(100.0);
  ActuatorCommand command;
  command.torque_Nm.setOnes(3);
  EXPECT_TRUE(Passive().Solve(state, com, TwoFeet(), &command).ok);
  EXPECT_EQ(command.torque_Nm, Eigen::VectorXd::Zero(3));
  EXPECT_TRUE(command.centroidal_feet.empty()) << "a robot has joints";
}

TEST(WholeBodyTest, PassiveOnTheCentroidalPlantPushesOnNothing) {
  ActuatorCommand command;
  Passive().Solve(RobotState{}, {}, TwoFeet(), &command);
  ASSERT_EQ(command.centroidal_feet.size(), 2U);
  for (const CentroidalFootCommand& foot : command.centroidal_feet) {
    EXPECT_FALSE(foot.in_contact);
    EXPECT_EQ(foot.force_N, Eigen::Matrix3Xd::Zero(3, 4));
  }
}

TEST(WholeBodyTest, CentroidalForcesHandsTheTargetsOn) {
  const std::vector<FootTarget> feet = TwoFeet();
  ActuatorCommand command;
  EXPECT_TRUE(CentroidalForces().Solve(RobotState{}, {}, feet, &command).ok);
  ASSERT_EQ(command.centroidal_feet.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(command.centroidal_feet[i].in_contact, i == 0);
    EXPECT_EQ(command.centroidal_feet[i].p_WF, feet[i].p_WF);
    EXPECT_EQ(command.centroidal_feet[i].force_N, feet[i].vertex_force_N);
  }
}

}  // namespace
}  // namespace sidestep::wbc::whole_body_test
