// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// actuator_command: all that crosses from the controller to the world.

#include <Eigen/Core>
#include <vector>

namespace sidestep {

/// What the controller asks of a foot of the centroidal plant, which has no joints.
struct CentroidalFootCommand {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};  ///< Where the foot is or lands next (m).
  Eigen::Matrix3Xd force_N;                       ///< 3 x n_v, ground on robot, in W.
  bool in_contact{false};
};

/// Joint torques, or references of the joints' servos, or contact forces for the centroidal plant.
/// Joint vectors are in the order of the actuators.
struct ActuatorCommand {
  Eigen::VectorXd torque_Nm;       ///< N for a slide; empty when the servos are in charge.
  Eigen::VectorXd joint_position;  ///< Servo reference (rad); empty under torque control.
  Eigen::VectorXd joint_velocity;  ///< Servo reference (rad/s); as long as joint_position.
  std::vector<CentroidalFootCommand> centroidal_feet;  ///< Empty but on the centroidal plant.
};

}  // namespace sidestep
