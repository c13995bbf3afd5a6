// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_dynamics: joint torques from CoM, attitude, swing-foot and force targets, by one QP.
//
//   minimise   w_com |a_C - a_C*|^2 + w_att |wdot - wdot*|^2 + w_swing |a_F - a_F*|^2
//            + w_stand |a_F + k v_F|^2 + w_force |f - f*|^2 + w_posture |nudot|^2
//   over       nudot (nv), f (3 a point foot in contact)
//   subject to the base's six rows of M nudot + h = sum J^T f,
//              f inside its friction pyramid, f_z >= 0, |tau| <= limit
//
// with tau = (M nudot + h - J^T f) at the actuated rows. Always feasible: f = 0, tau = 0 keeps
// every hard row. Targets a* are the MPC's accelerations plus feedback of position and velocity.
// Source: the usual weighted form, e.g. Herzog et al., "Momentum control with hierarchical inverse
// dynamics on a torque-controlled humanoid", Autonomous Robots 40 (2016).

#include <Eigen/Core>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/control_params.h"
#include "controller/wbc/qp/dense_qp.h"
#include "controller/wbc/whole_body.h"

namespace sidestep::wbc {

class InverseDynamics final : public WholeBody {
 public:
  /// `rigid_body` must outlive this object and be updated, Jacobians and bias too, to the state
  /// given to Solve().
  InverseDynamics(const RobotDescription& robot, const InverseDynamicsParams& params,
                  const RigidBody* rigid_body);

  WbcReport Solve(const RobotState& state, const ComTarget& com,
                  const std::vector<FootTarget>& feet, ActuatorCommand* command) override;

 private:
  void AddTask(const Eigen::Ref<const Jacobian3>& J, const Eigen::Vector3d& target_minus_bias,
               const Eigen::Vector3d& weight);
  void AddComTask(const RobotState& state, const ComTarget& com);
  void AddAttitudeTask(const RobotState& state, bool yaw_is_held);
  void AddFootTasks(const RobotState& state, const std::vector<FootTarget>& feet);
  void AddForces(const RobotState& state, const std::vector<FootTarget>& feet);
  void AddRegularisation();
  void AddDynamics();
  void AddTorqueLimits();

  RobotDescription robot_;
  InverseDynamicsParams params_;
  const RigidBody* rigid_body_;
  Eigen::Index nv_;
  Eigen::Index num_forces_{0};  // 3 a foot in contact
  Eigen::Index num_inequalities_{0};
  Eigen::MatrixXd force_jacobian_;  // max forces x nv: rows of J at the feet in contact
  DenseQpProblem qp_;               // at its largest size; blocks of it are solved
  DenseQpSolver solver_;
  Eigen::VectorXd residual_;  // scratch of a solve: nv
};

}  // namespace sidestep::wbc
