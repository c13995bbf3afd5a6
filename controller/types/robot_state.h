// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_state: what the controller believes of the robot.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "controller/types/wrench.h"

namespace sidestep {

/// A foot as the belief has it; F is the sole's origin. Pose and velocity come by kinematics from
/// base and joints, so they carry the base's errors; contact and wrench come from the foot's
/// sensors alone.
struct FootState {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};  ///< m.
  Eigen::Matrix3d R_WF{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};  ///< m/s, of F.
  Eigen::Vector3d w_WF{Eigen::Vector3d::Zero()};  ///< Angular velocity, in W.
  bool in_contact{false};                         ///< Felt now, whatever the schedule says.
  Wrench
      wrench;  ///< Ground on foot about F, in W, as its sensors feel it; force z only from touch.
};

/// The one thing that planner, MPC and whole-body stage know of the robot. Base and joints are
/// primary; CoM, momentum and the feet's motion follow from them by RigidBody::FillDerived() and
/// belong to the same instant. On the centroidal plant CoM, momentum and feet are measured
/// themselves, and there are no joints.
struct RobotState {
  Eigen::Vector3d p_WB{Eigen::Vector3d::Zero()};  ///< m.
  Eigen::Quaterniond q_WB{Eigen::Quaterniond::Identity()};
  Eigen::Vector3d v_WB{Eigen::Vector3d::Zero()};    ///< Of B's origin, in W.
  Eigen::Vector3d w_WB_B{Eigen::Vector3d::Zero()};  ///< In B.
  Eigen::VectorXd joint_position;                   ///< rad or m, order of the actuators.
  Eigen::VectorXd joint_velocity;                   ///< rad/s or m/s, likewise.
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};              ///< m/s.
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};  ///< h_C_W, kg m^2/s.
  std::vector<FootState> feet;  ///< In the order of RobotDescription::feet.
  Wrench external_wrench;       ///< About C, in W; zero when unknown.
};

}  // namespace sidestep
