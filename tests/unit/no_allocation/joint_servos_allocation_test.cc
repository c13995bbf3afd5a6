// SPDX-License-Identifier: BSD-3-Clause
// Servos run at every physics step: they take no memory once they are there.
#include <gtest/gtest.h>

#include "sim/actuators/joint_servos.h"
#include "tests/support/allocation_counter.h"

namespace sidestep::joint_servos_allocation_test {
namespace {

TEST(JointServosAllocationTest, CommandsAndStepsTakeNoMemory) {
  constexpr Eigen::Index kJoints = 23;
  Eigen::MatrixX2d range_Nm(kJoints, 2);
  range_Nm.col(0).setConstant(-40.0);
  range_Nm.col(1).setConstant(40.0);
  JointServos servos(std::vector<JointDescription>(kJoints, {"joint", 100.0, 2.0, 10.0, 1.0}),
                     range_Nm);
  ActuatorCommand references, torques;
  references.joint_position.setConstant(kJoints, 0.1);
  references.joint_velocity.setZero(kJoints);
  torques.torque_Nm.setConstant(kJoints, 3.0);
  const Eigen::VectorXd state = Eigen::VectorXd::Zero(kJoints);

  const std::int64_t before = CountAllocations();
  for (int step = 0; step < 10; ++step) {
    servos.Apply(step % 2 == 0 ? references : torques);
    servos.Update(state, state);
  }
  EXPECT_EQ(CountAllocations() - before, 0);
  EXPECT_EQ(servos.torque_Nm()[0], 3.0);
}

}  // namespace
}  // namespace sidestep::joint_servos_allocation_test
