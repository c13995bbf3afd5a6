// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/inverse_dynamics.h"

#include "controller/model/upright.h"
#include "models/support/require.h"

namespace sidestep::wbc {
namespace {

constexpr Eigen::Index kBase = 6;             // unactuated rows
constexpr Eigen::Index kPyramidRows = 4;      // |fx| + |fy| <= mu fz implies fz >= 0
constexpr double kStandWeight = 10.0;         // a standing foot does not accelerate
constexpr double kStandDamping_per_s = 20.0;  // and loses what speed it has

Eigen::Index MaxForces(const RobotDescription& robot) {
  Eigen::Index vertices = 0;
  for (const FootDescription& foot : robot.feet) vertices += foot.vertices_m.cols();
  return 3 * vertices;
}

DenseQpDimensions MaxDimensions(const RobotDescription& robot, const RigidBody& body) {
  const Eigen::Index forces = MaxForces(robot);
  return {static_cast<int>(body.num_velocities() + forces), static_cast<int>(kBase),
          static_cast<int>(kPyramidRows * forces / 3 + body.num_actuators())};
}

}  // namespace

InverseDynamics::InverseDynamics(const RobotDescription& robot, const InverseDynamicsParams& params,
                                 const RigidBody* rigid_body)
    : robot_(robot),
      params_(params),
      rigid_body_(rigid_body),
      nv_(rigid_body->num_velocities()),
      solver_(MaxDimensions(robot, *rigid_body)) {
  for (const FootDescription& foot : robot.feet) {
    SIDESTEP_REQUIRE(foot.vertices_m.cols() == 1, foot.name);  // point feet
  }
  const DenseQpDimensions maxima = MaxDimensions(robot, *rigid_body);
  force_jacobian_.setZero(MaxForces(robot), nv_);
  qp_.H.setZero(maxima.variables, maxima.variables);
  qp_.g.setZero(maxima.variables);
  qp_.A.setZero(maxima.equalities, maxima.variables);
  qp_.b.setZero(maxima.equalities);
  qp_.C.setZero(maxima.inequalities, maxima.variables);
  qp_.lower.setConstant(maxima.inequalities, -kInfinity);
  qp_.upper.setConstant(maxima.inequalities, kInfinity);
  residual_.setZero(nv_);
}

WbcReport InverseDynamics::Solve(const RobotState& state, const ComTarget& com,
                                 const std::vector<FootTarget>& feet, ActuatorCommand* command) {
  qp_.H.setZero();
  qp_.g.setZero();
  qp_.A.setZero();
  qp_.C.setZero();
  num_forces_ = 0;
  num_inequalities_ = 0;

  AddForces(state, feet);
  AddComTask(state, com);
  AddAttitudeTask(state, num_forces_ > 3);
  AddFootTasks(state, feet);
  AddRegularisation();
  AddDynamics();
  AddTorqueLimits();

  const Eigen::Index n = nv_ + num_forces_;
  const Eigen::Index m = num_inequalities_;
  const DenseQpSolution& solution =
      solver_.Solve({qp_.H.topLeftCorner(n, n), qp_.g.head(n), qp_.A.leftCols(n), qp_.b,
                     qp_.C.topLeftCorner(m, n), qp_.lower.head(m), qp_.upper.head(m)});
  WbcReport report{solution.status, solution.status == QpStatus::kSolved, solution.iterations};
  if (command->torque_Nm.size() == 0) command->torque_Nm.setZero(rigid_body_->num_actuators());
  if (!report.ok) return report;

  residual_ = rigid_body_->bias();
  residual_.noalias() += rigid_body_->mass_matrix() * solution.x.head(nv_);
  residual_.noalias() -=
      force_jacobian_.topRows(num_forces_).transpose() * solution.x.segment(nv_, num_forces_);
  for (std::size_t i = 0; i < rigid_body_->actuated_velocity().size(); ++i) {
    command->torque_Nm[static_cast<Eigen::Index>(i)] =
        residual_[rigid_body_->actuated_velocity()[i]];
  }
  return report;
}

// Adds 1/2 |J nudot - target|^2_w over the velocities' block.
void InverseDynamics::AddTask(const Eigen::Ref<const Jacobian3>& J,
                              const Eigen::Vector3d& target_minus_bias,
                              const Eigen::Vector3d& weight) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    qp_.H.topLeftCorner(nv_, nv_).noalias() += weight[axis] * J.row(axis).transpose() * J.row(axis);
    qp_.g.head(nv_) -= weight[axis] * target_minus_bias[axis] * J.row(axis).transpose();
  }
}

void InverseDynamics::AddComTask(const RobotState& state, const ComTarget& com) {
  if (num_forces_ == 0) return;  // in flight nothing moves the CoM
  const Eigen::Vector3d a_WC = com.a_WC + params_.com_stiffness_per_s2 * (com.p_WC - state.p_WC) +
                               params_.com_damping_per_s * (com.v_WC - state.v_WC);
  AddTask(rigid_body_->com_jacobian(), a_WC - rigid_body_->com_bias_mps2(),
          Eigen::Vector3d::Constant(params_.com_weight));
}

void InverseDynamics::AddAttitudeTask(const RobotState& state, bool yaw_is_held) {
  const Eigen::Vector3d wdot_B = params_.attitude_stiffness_per_s2 * UprightError_B(state.q_WB) -
                                 params_.attitude_damping_per_s * state.w_WB_B;
  // A single point of contact has no grip about the vertical.
  const double yaw_weight = yaw_is_held ? params_.attitude_weight : 0.0;
  const Eigen::Vector3d weight(params_.attitude_weight, params_.attitude_weight, yaw_weight);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    qp_.H(3 + axis, 3 + axis) += weight[axis];
    qp_.g[3 + axis] -= weight[axis] * wdot_B[axis];
  }
}

void InverseDynamics::AddFootTasks(const RobotState& state, const std::vector<FootTarget>& feet) {
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const FootKinematics& foot = rigid_body_->feet()[i];
    if (feet[i].planned_contact && state.feet[i].in_contact) {
      AddTask(foot.J, -kStandDamping_per_s * foot.v_WF - foot.bias_mps2,
              Eigen::Vector3d::Constant(kStandWeight));
      continue;
    }
    const Eigen::Vector3d a_WF = feet[i].a_WF +
                                 params_.swing_stiffness_per_s2 * (feet[i].p_WF - foot.p_WF) +
                                 params_.swing_damping_per_s * (feet[i].v_WF - foot.v_WF);
    AddTask(foot.J, a_WF - foot.bias_mps2, Eigen::Vector3d::Constant(params_.swing_weight));
  }
}

// Forces exist where the plan and the sensor agree that the foot stands.
void InverseDynamics::AddForces(const RobotState& state, const std::vector<FootTarget>& feet) {
  const Eigen::Vector3d pyramid[kPyramidRows] = {{1, 1, -params_.friction},
                                                 {-1, 1, -params_.friction},
                                                 {-1, -1, -params_.friction},
                                                 {1, -1, -params_.friction}};
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (!feet[i].planned_contact || !state.feet[i].in_contact) continue;
    const Eigen::Index column = nv_ + num_forces_;
    force_jacobian_.middleRows<3>(num_forces_) = rigid_body_->feet()[i].J;
    for (const Eigen::Vector3d& row : pyramid) {  // the floor is level
      qp_.C.block<1, 3>(num_inequalities_, column) = row.transpose();
      qp_.lower[num_inequalities_] = -kInfinity;
      qp_.upper[num_inequalities_] = 0.0;
      ++num_inequalities_;
    }
    qp_.H.diagonal().segment<3>(column).array() += params_.force_weight;
    qp_.g.segment<3>(column) -= params_.force_weight * feet[i].vertex_force_N.col(0);
    num_forces_ += 3;
  }
}

void InverseDynamics::AddRegularisation() {
  qp_.H.diagonal().head(nv_).array() += params_.posture_weight;
}

void InverseDynamics::AddDynamics() {
  qp_.A.leftCols(nv_) = rigid_body_->mass_matrix().topRows<kBase>();
  qp_.A.middleCols(nv_, num_forces_) =
      -force_jacobian_.topRows(num_forces_).leftCols<kBase>().transpose();
  qp_.b = -rigid_body_->bias().head<kBase>();
}

void InverseDynamics::AddTorqueLimits() {
  for (std::size_t i = 0; i < rigid_body_->actuated_velocity().size(); ++i) {
    const Eigen::Index row = rigid_body_->actuated_velocity()[i];
    const double limit_Nm = rigid_body_->torque_limit_Nm()[static_cast<Eigen::Index>(i)];
    qp_.C.row(num_inequalities_).head(nv_) = rigid_body_->mass_matrix().row(row);
    qp_.C.row(num_inequalities_).segment(nv_, num_forces_) =
        -force_jacobian_.topRows(num_forces_).col(row).transpose();
    qp_.lower[num_inequalities_] = -limit_Nm - rigid_body_->bias()[row];
    qp_.upper[num_inequalities_] = limit_Nm - rigid_body_->bias()[row];
    ++num_inequalities_;
  }
}

}  // namespace sidestep::wbc
