// SPDX-License-Identifier: BSD-3-Clause
#include "sim/actuators/joint_servos.h"

#include <gtest/gtest.h>

#include <limits>

#include "models/support/require.h"

namespace sidestep::joint_servos_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Eigen::Vector2d kStill = Eigen::Vector2d::Zero();

/// Gains 100 and 2, and 50 and 1; the second motor has no limit, the first an uneven one.
JointServos TwoServos() {
  Eigen::MatrixX2d range_Nm(2, 2);
  range_Nm << -5.0, 8.0, -kInfinity, kInfinity;
  return {{{"hip", 100.0, 2.0, 10.0, 1.0}, {"knee", 50.0, 1.0, 10.0, 1.0}}, range_Nm};
}

ActuatorCommand Torque(double hip_Nm, double knee_Nm) {
  ActuatorCommand command;
  command.torque_Nm = Eigen::Vector2d(hip_Nm, knee_Nm);
  return command;
}

ActuatorCommand Reference(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity) {
  ActuatorCommand command;
  command.joint_position = position;
  command.joint_velocity = velocity;
  return command;
}

TEST(JointServosTest, GiveNothingBeforeTheFirstCommand) {
  JointServos servos = TwoServos();
  servos.Update(Eigen::Vector2d(1.0, -1.0), Eigen::Vector2d(2.0, 3.0));
  EXPECT_EQ(servos.torque_Nm(), kStill);
  EXPECT_EQ(servos.num_saturated(), 0);
}

TEST(JointServosTest, TorquesPassThrough) {
  JointServos servos = TwoServos();
  servos.Apply(Torque(3.0, -400.0));
  servos.Update(Eigen::Vector2d(1.0, -1.0), Eigen::Vector2d(2.0, 3.0));
  EXPECT_EQ(servos.torque_Nm(), Eigen::Vector2d(3.0, -400.0));
  EXPECT_EQ(servos.num_saturated(), 0);
}

TEST(JointServosTest, ReferencesPullByStiffnessAndDamping) {
  JointServos servos = TwoServos();
  servos.Apply(Reference({0.05, -0.2}, {0.5, 1.0}));
  servos.Update(Eigen::Vector2d(0.02, 0.1), Eigen::Vector2d(0.1, -2.0));
  // By hand: 100 x 0.03 + 2 x 0.4 and 50 x -0.3 + 1 x 3.
  EXPECT_LT((servos.torque_Nm() - Eigen::Vector2d(3.8, -12.0)).norm(), 1e-12);
}

TEST(JointServosTest, ReferencesStayWhileTheJointsMove) {
  JointServos servos = TwoServos();
  servos.Apply(Reference({0.05, 0.0}, kStill));
  servos.Update(kStill, kStill);
  EXPECT_NEAR(servos.torque_Nm()[0], 5.0, 1e-12);
  servos.Update(Eigen::Vector2d(0.04, 0.0), kStill);
  EXPECT_NEAR(servos.torque_Nm()[0], 1.0, 1e-12) << "no new command";
  servos.Apply(Reference({0.0, 0.0}, kStill));
  servos.Update(Eigen::Vector2d(0.04, 0.0), kStill);
  EXPECT_NEAR(servos.torque_Nm()[0], -4.0, 1e-12);
}

TEST(JointServosTest, MotorsGiveNoMoreThanTheyCanAndTellIt) {
  JointServos servos = TwoServos();
  servos.Apply(Reference({0.1, 0.1}, kStill));
  servos.Update(kStill, kStill);
  EXPECT_EQ(servos.torque_Nm()[0], 8.0);
  EXPECT_NEAR(servos.torque_Nm()[1], 5.0, 1e-12);
  EXPECT_EQ(servos.num_saturated(), 1);
  servos.Update(Eigen::Vector2d(0.2, 0.0), kStill);
  EXPECT_EQ(servos.torque_Nm()[0], -5.0);
  servos.Update(Eigen::Vector2d(0.1, 0.0), kStill);
  EXPECT_EQ(servos.num_saturated(), 0);
  servos.Apply(Torque(-7.0, 0.0));
  servos.Update(kStill, kStill);
  EXPECT_EQ(servos.torque_Nm()[0], -5.0) << "under torque control too";
  EXPECT_EQ(servos.num_saturated(), 1);
}

TEST(JointServosTest, TorqueControlCanTakeOver) {
  JointServos servos = TwoServos();
  servos.Apply(Reference({0.01, 0.1}, kStill));
  servos.Apply(Torque(1.0, 2.0));
  servos.Update(kStill, kStill);
  EXPECT_EQ(servos.torque_Nm(), Eigen::Vector2d(1.0, 2.0));
}

TEST(JointServosTest, CommandsOfAnotherShapeBreakTheContract) {
  JointServos servos = TwoServos();
  ActuatorCommand command;
  EXPECT_THROW(servos.Apply(command), ContractViolation) << "neither";
  command.joint_position = kStill;
  EXPECT_THROW(servos.Apply(command), ContractViolation) << "no velocity";
  command.joint_velocity = kStill;
  EXPECT_NO_THROW(servos.Apply(command));
  command.torque_Nm = kStill;
  EXPECT_THROW(servos.Apply(command), ContractViolation) << "both";
  command = {};
  command.torque_Nm.setZero(3);
  EXPECT_THROW(servos.Apply(command), ContractViolation);
  command = {};
  command.joint_position.setZero(1);
  command.joint_velocity.setZero(1);
  EXPECT_THROW(servos.Apply(command), ContractViolation);

  JointServos motors_only({}, Eigen::MatrixX2d::Zero(2, 2));
  EXPECT_NO_THROW(motors_only.Apply(Torque(1.0, 1.0)));
  EXPECT_THROW(motors_only.Apply(Reference(kStill, kStill)), ContractViolation);
  EXPECT_THROW(JointServos({{"hip", 1.0, 1.0, 1.0, 1.0}}, Eigen::MatrixX2d::Zero(2, 2)),
               ContractViolation);
}

}  // namespace
}  // namespace sidestep::joint_servos_test
