// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_state: what the controller believes of the robot.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "controller/types/wrench.h"

namespace sidestep {

struct FootState {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R_WF{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d w_WF{Eigen::Vector3d::Zero()};  ///< Angular velocity, in W.
  bool in_contact{false};
  Wrench
      wrench;  ///< Ground on foot about F, in W, as its sensors feel it; force z only from touch.
};

struct RobotState {
  Eigen::Vector3d p_WB{Eigen::Vector3d::Zero()};
  Eigen::Quaterniond q_WB{Eigen::Quaterniond::Identity()};
  Eigen::Vector3d v_WB{Eigen::Vector3d::Zero()};    ///< Of B's origin, in W.
  Eigen::Vector3d w_WB_B{Eigen::Vector3d::Zero()};  ///< In B.
  Eigen::VectorXd joint_position;                   ///< rad or m, order of the actuators.
  Eigen::VectorXd joint_velocity;
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};  ///< h_C_W, kg m^2/s.
  std::vector<FootState> feet;
  Wrench external_wrench;  ///< About C, in W; zero when unknown.
};

}  // namespace sidestep
