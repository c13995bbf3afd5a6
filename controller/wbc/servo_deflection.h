// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// servo_deflection: how far servos give way under the torques that the plan asks of them.
//
// A servo of stiffness k holds torque tau only at an error tau / k. Adding that error to the
// reference makes the joint arrive where it is wanted:
//   q_ref = q + tau / k,   tau = h(q, nu) - sum_F J_F^T w_F
// with the plan's contact wrenches w_F. Source: the actuated rows of the equation of motion.

#include <Eigen/Core>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/control_tick.h"

namespace sidestep::wbc {

class ServoDeflection {
 public:
  /// `dt_s` is the control period; planned wrenches are smoothed over a few of the plan's knots'
  /// fractions, because they jump when a foot lands or leaves.
  ServoDeflection(const RobotDescription& robot, double dt_s);

  /// Deflections of the joints (rad, order of the actuators) at the state of `body`. Torques are
  /// kept within the motors' limits. Does not allocate after the first call.
  const Eigen::VectorXd& Update(const RigidBody& body, const std::vector<FootTarget>& feet);

 private:
  std::vector<Eigen::Matrix3Xd> vertices_m_;
  Eigen::VectorXd stiffness_;
  double share_;                                     // of the smoothing, per tick
  std::vector<Eigen::Matrix<double, 6, 1>> wrench_;  // [force; moment about F] of each foot, in W
  bool has_wrench_{false};
  Eigen::VectorXd torque_;      // nv
  Eigen::VectorXd deflection_;  // one a joint
};

}  // namespace sidestep::wbc
