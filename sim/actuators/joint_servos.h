// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// joint_servos: what stands between a command and the motors, at every physics step.
//
//   tau = kp (q_ref - q) + kd (v_ref - v)   or   tau = the command's torque,
//
// cut to what the motor gives. References stay as they are between two commands.

#include <Eigen/Core>
#include <vector>

#include "controller/types/actuator_command.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

class JointServos {
 public:
  /// Without a command the motors give nothing.
  /// @param joints    Gains, in the order of the actuators; empty for a robot without servos.
  /// @param range_Nm  Least and greatest torque of each motor, least <= greatest (N for a slide);
  ///                  infinite for one without limit.
  JointServos(std::vector<JointDescription> joints, Eigen::MatrixX2d range_Nm);

  /// Holds `command` until the next one. It has either a torque or a reference position and
  /// velocity for each motor, the latter only if there are servos; anything else is a
  /// ContractViolation. Does not allocate.
  void Apply(const ActuatorCommand& command);

  /// Computes torque_Nm() for the joints as they are now (rad, rad/s; m, m/s for a slide). Does
  /// not allocate.
  void Update(const Eigen::Ref<const Eigen::VectorXd>& position,
              const Eigen::Ref<const Eigen::VectorXd>& velocity);

  /// Torques of the last Update(), within the motors' ranges; zero before.
  const Eigen::VectorXd& torque_Nm() const { return torque_Nm_; }

  /// Motors that the last Update() would have had give more than they can.
  int num_saturated() const { return num_saturated_; }

 private:
  std::vector<JointDescription> joints_;
  Eigen::MatrixX2d range_Nm_;
  bool holds_references_{false};
  Eigen::VectorXd commanded_Nm_;
  Eigen::VectorXd position_reference_;
  Eigen::VectorXd velocity_reference_;
  Eigen::VectorXd torque_Nm_;
  int num_saturated_{0};
};

}  // namespace sidestep
