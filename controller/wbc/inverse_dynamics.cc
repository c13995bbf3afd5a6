// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/inverse_dynamics.h"

#include "controller/model/upright.h"
#include "controller/wbc/equation_of_motion.h"
#include "controller/wbc/tasks.h"
#include "models/support/require.h"

namespace sidestep::wbc {
namespace {

constexpr double kStandWeight = 10.0;         // a standing foot does not accelerate
constexpr double kStandDamping_per_s = 20.0;  // and loses what speed it has

DenseQpDimensions MaxDimensions(const ContactForces& forces, const RigidBody& body) {
  return {static_cast<int>(body.num_velocities() + forces.max_size()), body.num_base_velocities(),
          static_cast<int>(forces.max_cone_rows() + body.num_actuators())};
}

}  // namespace

InverseDynamics::InverseDynamics(const RobotDescription& robot, const InverseDynamicsParams& params,
                                 const RigidBody& body)
    : params_(params),
      forces_(robot, body.num_velocities(), params.friction),
      qp_(MaxDimensions(forces_, body)),
      solver_(MaxDimensions(forces_, body)) {
  for (const FootDescription& foot : robot.feet) {
    SIDESTEP_REQUIRE(foot.vertices_m.cols() == 1, foot.name);  // point feet
  }
  scratch_.setZero(body.num_velocities());
}

std::unique_ptr<WholeBody> InverseDynamics::Clone() const {
  return std::make_unique<InverseDynamics>(*this);
}

WbcReport InverseDynamics::Solve(const RobotState& state, const RigidBody& body,
                                 const ComTarget& com, const std::vector<FootTarget>& feet,
                                 ActuatorCommand* command) {
  Build(state, body, com, feet);
  const DenseQpSolution& solution = solver_.Solve(qp_.View());
  const WbcReport report{solution.status, solution.status == QpStatus::kSolved,
                         solution.iterations};
  if (command->torque_Nm.size() == 0) command->torque_Nm.setZero(body.num_actuators());
  if (report.ok) WriteTorques(body, forces_, solution.x, &scratch_, &command->torque_Nm);
  return report;
}

// The list of tasks, and what they must not break.
void InverseDynamics::Build(const RobotState& state, const RigidBody& body, const ComTarget& com,
                            const std::vector<FootTarget>& feet) {
  const Eigen::Index nv = body.num_velocities();
  forces_.Update(state, body, feet);
  qp_.Start(nv + forces_.size());

  if (forces_.size() > 0) {  // in flight nothing moves the CoM
    const Eigen::Vector3d a_WC =
        TrackedAcceleration({com.p_WC, com.v_WC, com.a_WC}, state.p_WC, state.v_WC,
                            params_.com_stiffness_per_s2, params_.com_damping_per_s);
    qp_.AddTask(ComAcceleration(body, a_WC), Eigen::Vector3d::Constant(params_.com_weight));
  }
  AddAttitude(state, body);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    AddFoot(i, feet[i].supports, body, feet[i]);
  }
  for (Eigen::Index i = 0; i < nv; ++i) qp_.AddDiagonal(i, 0.0, params_.posture_weight);
  forces_.AddPlanTo(params_.force_weight, &qp_);

  AddBaseRows(body, forces_, &qp_);
  forces_.AddConesTo(&qp_);
  AddTorqueLimits(body, forces_, &qp_);
}

// wdot_WB_B is nudot's own, so that J picks axes: upright, and at rest about the vertical.
void InverseDynamics::AddAttitude(const RobotState& state, const RigidBody& body) {
  const Eigen::Vector3d wdot_B = params_.attitude_stiffness_per_s2 * UprightError_B(state.q_WB) -
                                 params_.attitude_damping_per_s * state.w_WB_B;
  // A single point of contact has no grip about the vertical.
  const double yaw_weight = forces_.size() > 3 ? params_.attitude_weight : 0.0;
  const Eigen::Vector3d weight(params_.attitude_weight, params_.attitude_weight, yaw_weight);
  Eigen::Index row = body.base().num_linear();
  for (const int axis : body.base().angular_axes()) {
    qp_.AddDiagonal(row++, wdot_B[axis], weight[axis]);
  }
}

void InverseDynamics::AddFoot(std::size_t foot, bool stands, const RigidBody& body,
                              const FootTarget& target) {
  const FootKinematics& now = body.feet()[foot];
  if (stands) {
    qp_.AddTask(FootLinearAcceleration(body, foot, -kStandDamping_per_s * now.v_WF),
                Eigen::Vector3d::Constant(kStandWeight));
    return;
  }
  const Eigen::Vector3d a_WF =
      TrackedAcceleration({target.p_WF, target.v_WF, target.a_WF}, now.p_WF, now.v_WF,
                          params_.swing_stiffness_per_s2, params_.swing_damping_per_s);
  qp_.AddTask(FootLinearAcceleration(body, foot, a_WF),
              Eigen::Vector3d::Constant(params_.swing_weight));
}

}  // namespace sidestep::wbc
