// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_dynamics: joint torques from CoM, attitude, swing-foot and force targets, by one QP.
//
//   minimise   w_com |a_C - a_C*|^2 + w_att |wdot - wdot*|^2 + w_swing |a_F - a_F*|^2
//            + w_stand |a_F + k v_F|^2 + w_force |f - f*|^2 + w_posture |nudot|^2
//   over       nudot (nv), f (3 a point foot in contact)
//   subject to the base's rows of M nudot + h = sum J^T f,
//              f inside its friction pyramid, f_z >= 0, |tau| <= limit
//
// with tau = (M nudot + h - J^T f) at the actuated rows. Always feasible: f = 0, tau = 0 keeps
// every hard row. Targets a* are the MPC's accelerations plus feedback of position and velocity.
// Source: the usual weighted form, e.g. Herzog et al., "Momentum control with hierarchical inverse
// dynamics on a torque-controlled humanoid", Autonomous Robots 40 (2016).

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "controller/types/control_params.h"
#include "controller/wbc/contact_forces.h"
#include "controller/wbc/qp/dense_qp.h"
#include "controller/wbc/qp_builder.h"
#include "controller/wbc/whole_body.h"

namespace sidestep::wbc {

class InverseDynamics final : public WholeBody {
 public:
  /// `body` is the robot, for its sizes. Throws ContractViolation if a foot has more than one
  /// vertex.
  InverseDynamics(const RobotDescription& robot, const InverseDynamicsParams& params,
                  const RigidBody& body);

  WbcReport Solve(const RobotState& state, const RigidBody& body, const ComTarget& com,
                  const std::vector<FootTarget>& feet, ActuatorCommand* command) override;
  std::unique_ptr<WholeBody> Clone() const override;

 private:
  void Build(const RobotState& state, const RigidBody& body, const ComTarget& com,
             const std::vector<FootTarget>& feet);
  void AddAttitude(const RobotState& state, const RigidBody& body);
  void AddFoot(std::size_t foot, bool stands, const RigidBody& body, const FootTarget& target);

  InverseDynamicsParams params_;
  ContactForces forces_;
  QpBuilder qp_;
  DenseQpSolver solver_;
  Eigen::VectorXd scratch_;  // nv
};

}  // namespace sidestep::wbc
