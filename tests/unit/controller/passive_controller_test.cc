// SPDX-License-Identifier: BSD-3-Clause
#include "controller/passive_controller.h"

#include <gtest/gtest.h>

namespace sidestep::passive_controller_test {
namespace {

SensorFrame FrameOf(Eigen::Index num_joints) {
  SensorFrame frame;
  frame.tick = 3;
  frame.joint_position.setConstant(num_joints, 0.1);
  frame.joint_velocity.setConstant(num_joints, 2.0);
  return frame;
}

TEST(PassiveControllerTest, CommandsZeroTorqueToEveryJoint) {
  PassiveController controller({});
  const ControlTick& answer = controller.Update(FrameOf(3));
  EXPECT_EQ(answer.tick, 3);
  EXPECT_EQ(answer.command.torque_Nm, Eigen::Vector3d::Zero());
  EXPECT_EQ(answer.command.joint_position.size(), 0);
}

TEST(PassiveControllerTest, CommandsNoForceOnTheCentroidalPlant) {
  ControllerSetup setup;
  setup.is_centroidal = true;
  PassiveController controller(setup);
  const ControlTick& answer = controller.Update(FrameOf(0));
  EXPECT_TRUE(answer.command.centroidal_feet.empty());
  EXPECT_EQ(answer.command.torque_Nm.size(), 0);
}

TEST(PassiveControllerTest, BelievesAndPlansNothing) {
  PassiveController controller({});
  const ControlTick& answer = controller.Update(FrameOf(3));
  EXPECT_TRUE(answer.state.feet.empty());
  EXPECT_TRUE(answer.feet.empty());
  EXPECT_FALSE(answer.mpc.ran);
  EXPECT_TRUE(controller.LastProblemJson("problem").empty());
}

}  // namespace
}  // namespace sidestep::passive_controller_test
