// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_dynamics: joint torques from targets of CoM, momentum, trunk, feet and forces, by one QP.
//
//   minimise   w_com |a_C - a_C*|^2 + w_mom |sum (p_V - p_C) x f_V - hdot*|^2 / (m h)^2
//            + w_att |wdot_T - wdot_T*|^2 + w_post |qddot - qddot*|^2
//            + w_swing |a_F - a_F*|^2 + w_swing,rot |wdot_F - wdot_F*|^2        feet in the air
//            + w_stand |a_F + k v_F|^2 + w_stand,rot |wdot_F - wdot_F*|^2       feet on the ground
//            + w_force |f - f*|^2 / (m g)^2
//   over       nudot (nv), f (3 a vertex in contact)
//   subject to the base's rows of M nudot + h = sum J^T f + e,
//              f inside its friction pyramid, f_z >= 0, |tau| <= limit,
//              qddot within what positions and speeds of the joints allow (joint_limits)
//
// with tau = (M nudot + h - J^T f) at the actuated rows. Starred terms are the plan's feed-forward
// plus feedback of position and velocity, so that between two solves of the MPC its errors are
// corrected here. Contacts are tasks of high weight: the problem is always feasible, for f = 0 and
// what the motors can do to keep the joints' limits is a point of it.
//
// Angular momentum has one owner, the MPC: it plans it, the forces follow that plan, and what they
// leave to the trunk and the posture is soft. With angular_momentum_weight 0 the trunk's task owns
// it, and is to be stiff. Both strong fight each other at the friction pyramids.
//
// Feet differ by their vertices alone: a sole of several has six rows, one of a single point three.
// The trunk is the torso's site or, where there is none, the base.
// Source: the usual weighted form, e.g. Herzog et al., "Momentum control with hierarchical inverse
// dynamics on a torque-controlled humanoid", Autonomous Robots 40 (2016).

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "controller/types/control_params.h"
#include "controller/wbc/contact_forces.h"
#include "controller/wbc/joint_limits.h"
#include "controller/wbc/qp/dense_qp.h"
#include "controller/wbc/qp_builder.h"
#include "controller/wbc/whole_body.h"

namespace sidestep::wbc {

class InverseDynamics final : public WholeBody {
 public:
  /// `body` is the nominal robot, for its sizes and its posture at home.
  InverseDynamics(const RobotDescription& robot, const InverseDynamicsParams& params,
                  const RigidBody& body);

  WbcReport Solve(const RobotState& state, const RigidBody& body, const ComTarget& com,
                  const std::vector<FootTarget>& feet, ActuatorCommand* command) override;
  std::unique_ptr<WholeBody> Clone() const override;

  /// The last problem solved.
  DenseQpView problem() const { return qp_.View(); }

 private:
  /// What the posture wants of an actuator's joint.
  struct JointPosture {
    double position{0.0};  ///< rad or m, at home.
    double weight{0.0};
  };

  void MakePosture(const RobotDescription& robot, const RigidBody& body);
  void Build(const RobotState& state, const RigidBody& body, const ComTarget& com,
             const std::vector<FootTarget>& feet);
  void AddCom(const RobotState& state, const RigidBody& body, const ComTarget& com);
  void AddAngularMomentum(const RobotState& state, const RigidBody& body, const ComTarget& com);
  void AddTrunk(const RobotState& state, const RigidBody& body,
                const std::vector<FootTarget>& feet);
  void AddPosture(const RobotState& state, const RigidBody& body);
  void AddFoot(std::size_t foot, const RigidBody& body, const FootTarget& target);

  InverseDynamicsParams params_;
  double com_height_m_;
  std::vector<bool> is_flat_;          // by foot: several vertices
  std::vector<JointPosture> posture_;  // one an actuator
  ContactForces forces_;
  JointLimits limits_;
  QpBuilder qp_;
  DenseQpSolver solver_;
  Eigen::VectorXd scratch_;  // nv
};

}  // namespace sidestep::wbc
