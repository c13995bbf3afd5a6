// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// joint_limits: what positions, speeds and torques of the joints allow their accelerations to be.
//
//   v_up = clamp(k_q (q_max - q), -v_max, v_max)       a joint may use up what is left to its end
//   qddot <= k_v (v_up - qdot)                         and reaches that speed from either side
//
// and the same downwards. A motor may be too weak to brake a joint that is too fast. Bounds and
// torque limits together are never without a solution all the same: a bound gives way to what the
// motors can do, with no force at the feet, against leaving it.
// Source: bounds as exponential barriers, e.g. Ames et al., "Control barrier functions", ECC 2019.

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "controller/model/rigid_body.h"
#include "controller/types/robot_state.h"
#include "controller/wbc/equation_of_motion.h"
#include "controller/wbc/qp_builder.h"

namespace sidestep::wbc {

class JointLimits {
 public:
  /// Position limits are the body's; speed limits are RobotDescription::joints', and none without.
  JointLimits(const RobotDescription& robot, const RigidBody& body);

  /// Makes the bounds for `body` at `state`. `external` is what acts on the base beside
  /// gravity and feet (equation_of_motion.h). Does not allocate.
  void Update(const RobotState& state, const RigidBody& body, const BaseForce& external);

  /// Bounds of each actuator's joint (rad/s^2, m/s^2); infinite where nothing limits it.
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }

  /// Rows that the bounds need at most.
  int max_rows() const { return static_cast<int>(lower_.size()); }

  /// The bounds, a row an actuator, as inequalities on the accelerations.
  void AddTo(const RigidBody& body, QpBuilder* qp) const;

 private:
  void GiveWay(const RigidBody& body, const BaseForce& external);
  /// Writes the motors' torques, cut to their limits; false if they were beyond them.
  bool FindTorques(const RigidBody& body);

  Eigen::VectorXd speed_limit_, lower_, upper_;  // one an actuator
  Eigen::VectorXd nudot_, acting_, torque_;      // nv
  Eigen::LLT<Eigen::MatrixXd> mass_, base_mass_;
};

}  // namespace sidestep::wbc
