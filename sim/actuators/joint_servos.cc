// SPDX-License-Identifier: BSD-3-Clause
#include "sim/actuators/joint_servos.h"

#include <algorithm>
#include <utility>

#include "models/support/require.h"

namespace sidestep {

JointServos::JointServos(std::vector<JointDescription> joints, Eigen::MatrixX2d range_Nm)
    : joints_(std::move(joints)), range_Nm_(std::move(range_Nm)) {
  const Eigen::Index motors = range_Nm_.rows();
  SIDESTEP_REQUIRE(joints_.empty() || static_cast<Eigen::Index>(joints_.size()) == motors,
                   joints_.size());
  SIDESTEP_REQUIRE((range_Nm_.col(0).array() <= range_Nm_.col(1).array()).all(), motors);
  for (Eigen::VectorXd* vector :
       {&commanded_Nm_, &position_reference_, &velocity_reference_, &torque_Nm_}) {
    vector->setZero(motors);
  }
}

void JointServos::Apply(const ActuatorCommand& command) {
  const Eigen::Index motors = range_Nm_.rows();
  holds_references_ = command.joint_position.size() > 0;
  if (!holds_references_) {
    SIDESTEP_REQUIRE(command.joint_velocity.size() == 0, command.joint_velocity.size());
    SIDESTEP_REQUIRE(command.torque_Nm.size() == motors, command.torque_Nm.size());
    commanded_Nm_ = command.torque_Nm;
    return;
  }
  SIDESTEP_REQUIRE(!joints_.empty(), motors);
  SIDESTEP_REQUIRE(command.torque_Nm.size() == 0, command.torque_Nm.size());
  SIDESTEP_REQUIRE(command.joint_position.size() == motors, command.joint_position.size());
  SIDESTEP_REQUIRE(command.joint_velocity.size() == motors, command.joint_velocity.size());
  position_reference_ = command.joint_position;
  velocity_reference_ = command.joint_velocity;
}

void JointServos::Update(const Eigen::Ref<const Eigen::VectorXd>& position,
                         const Eigen::Ref<const Eigen::VectorXd>& velocity) {
  const Eigen::Index motors = range_Nm_.rows();
  SIDESTEP_REQUIRE(position.size() == motors, position.size());
  SIDESTEP_REQUIRE(velocity.size() == motors, velocity.size());
  num_saturated_ = 0;
  for (Eigen::Index i = 0; i < motors; ++i) {
    double wanted_Nm = commanded_Nm_[i];
    if (holds_references_) {
      const JointDescription& joint = joints_[static_cast<std::size_t>(i)];
      wanted_Nm = joint.servo_stiffness_Nm_per_rad * (position_reference_[i] - position[i]) +
                  joint.servo_damping_Nms_per_rad * (velocity_reference_[i] - velocity[i]);
    }
    torque_Nm_[i] = std::clamp(wanted_Nm, range_Nm_(i, 0), range_Nm_(i, 1));
    if (torque_Nm_[i] != wanted_Nm) ++num_saturated_;
  }
}

}  // namespace sidestep
