// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/inverse_dynamics.h"

#include <algorithm>
#include <array>

#include "controller/model/upright.h"
#include "controller/wbc/equation_of_motion.h"
#include "controller/wbc/rotation.h"
#include "controller/wbc/tasks.h"

namespace sidestep::wbc {
namespace {

constexpr double kStandDamping_per_s = 20.0;      // a standing foot loses what speed it has,
constexpr double kStandStiffness_per_s2 = 100.0;  // and a sole its tilt: critical
constexpr std::array<int, 2> kHorizontalAxes{0, 1};
constexpr double kBaseWeight = 1e-4;  // of a base's acceleration that no task asks for

DenseQpDimensions MaxDimensions(const ContactForces& forces, const JointLimits& limits,
                                const RigidBody& body) {
  return {static_cast<int>(body.num_velocities() + forces.max_size()), body.num_base_velocities(),
          static_cast<int>(forces.max_rows() + body.num_actuators()) + limits.max_rows()};
}

}  // namespace

InverseDynamics::InverseDynamics(const RobotDescription& robot, const InverseDynamicsParams& params,
                                 const RigidBody& body)
    : params_(params),
      com_height_m_(robot.com_height_m),
      forces_(robot, body.num_velocities(), params.friction),
      limits_(robot, body),
      qp_(MaxDimensions(forces_, limits_, body)),
      solver_(MaxDimensions(forces_, limits_, body)) {
  for (const FootDescription& foot : robot.feet) is_flat_.push_back(foot.vertices_m.cols() > 1);
  scratch_.setZero(body.num_velocities());
  MakePosture(robot, body);
}

// A joint carries a foot if it moves one: its column of the foot's Jacobian is an axis, else zero.
void InverseDynamics::MakePosture(const RobotDescription& robot, const RigidBody& body) {
  RobotState home;
  home.feet.resize(robot.feet.size());
  RigidBody at_home(body);
  at_home.WriteHome(&home);
  at_home.Update(home);
  posture_.resize(static_cast<std::size_t>(body.num_actuators()));
  for (std::size_t i = 0; i < posture_.size(); ++i) {
    const int column = body.actuated_velocity()[i];
    bool carries_foot = false;
    for (std::size_t foot = 0; foot < robot.feet.size(); ++foot) {
      const FrameJacobian& jacobian = at_home.foot_jacobian(foot);
      carries_foot = carries_foot || !jacobian.J.col(column).isZero(0.0) ||
                     !jacobian.J_rot.col(column).isZero(0.0);
    }
    posture_[i].position = home.joint_position[static_cast<Eigen::Index>(i)];
    posture_[i].weight = carries_foot ? params_.leg_posture_weight : params_.posture_weight;
    if (!robot.joints.empty()) posture_[i].weight *= robot.joints[i].posture_weight;
  }
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
  const BaseForce external = OnBase(state.external_wrench, state);
  const double weight_N = body.mass_kg() * body.gravity_mps2().norm();
  forces_.Update(state, body, feet);
  limits_.Update(state, body, external);
  qp_.Start(body.num_velocities() + forces_.size());

  if (forces_.size() > 0) {  // in flight nothing moves the CoM nor turns the robot
    AddCom(state, body, com);
    AddAngularMomentum(state, body, com);
    forces_.AddPlanTo(params_.planned_force_weight / (weight_N * weight_N), &qp_);
  }
  AddTrunk(state, body, feet);
  AddPosture(state, body);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    AddFoot(i, body, feet[i]);
  }

  AddBaseRows(body, forces_, external, &qp_);
  forces_.AddLimitsTo(weight_N, &qp_);
  AddTorqueLimits(body, forces_, &qp_);
  limits_.AddTo(body, &qp_);
}

void InverseDynamics::AddCom(const RobotState& state, const RigidBody& body, const ComTarget& com) {
  Eigen::Vector3d a_WC =
      TrackedAcceleration({com.p_WC, com.v_WC, com.a_WC}, state.p_WC, state.v_WC,
                          params_.com_stiffness_per_s2, params_.com_damping_per_s);
  a_WC.z() = com.a_WC.z() + params_.height_stiffness_per_s2 * (com.p_WC.z() - state.p_WC.z()) +
             params_.height_damping_per_s * (com.v_WC.z() - state.v_WC.z());
  qp_.AddTask(ComAcceleration(body, a_WC), params_.com_weight);
}

// The ground's share of the momentum's rate: the plan's, corrected, less what a push does.
void InverseDynamics::AddAngularMomentum(const RobotState& state, const RigidBody& body,
                                         const ComTarget& com) {
  const Eigen::Vector3d moment_W =
      com.angular_momentum_rate_Nm +
      params_.angular_momentum_gain_per_s * (com.angular_momentum - state.angular_momentum) -
      state.external_wrench.torque_Nm;
  const double scale = body.mass_kg() * com_height_m_;
  forces_.AddMomentTo(state.p_WC, moment_W, params_.angular_momentum_weight / (scale * scale),
                      &qp_);
}

// Upright, and facing as flat feet do; points of contact have no heading to face along, and a
// single one has no grip about the vertical.
void InverseDynamics::AddTrunk(const RobotState& state, const RigidBody& body,
                               const std::vector<FootTarget>& feet) {
  const double stiffness = params_.attitude_stiffness_per_s2;
  const double damping = params_.attitude_damping_per_s;
  const bool has_grip_to_yaw = forces_.size() > 3;
  if (body.has_torso()) {
    const TorsoKinematics& torso = body.torso();
    const Eigen::Vector3d wdot_WT =
        stiffness * RotationError_W(torso.R_WT, UprightFacingAs(feet)) - damping * torso.w_WT;
    const Task task = TrunkAcceleration(body, wdot_WT);
    // A base that moves in a plane has no yaw to weigh.
    if (has_grip_to_yaw || body.base().is_sagittal()) {
      qp_.AddTask(task, params_.attitude_weight);
    } else {
      qp_.AddTask(task, params_.attitude_weight, kHorizontalAxes);
    }
    return;
  }
  // wdot_WB_B is nudot's own, so that J picks axes.
  const Eigen::Vector3d wdot_B = stiffness * UprightError_B(state.q_WB) - damping * state.w_WB_B;
  const double yaw_weight = has_grip_to_yaw ? params_.attitude_weight : 0.0;
  const Eigen::Vector3d weight(params_.attitude_weight, params_.attitude_weight, yaw_weight);
  Eigen::Index row = body.base().num_linear();
  for (const int axis : body.base().angular_axes()) {
    qp_.AddDiagonal(row++, wdot_B[axis], weight[axis]);
  }
}

void InverseDynamics::AddPosture(const RobotState& state, const RigidBody& body) {
  for (int i = 0; i < body.num_base_velocities(); ++i) qp_.AddDiagonal(i, 0.0, kBaseWeight);
  for (std::size_t i = 0; i < posture_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double wanted =
        params_.posture_stiffness_per_s2 * (posture_[i].position - state.joint_position[at]) -
        params_.posture_damping_per_s * state.joint_velocity[at];
    qp_.AddDiagonal(body.actuated_velocity()[i], wanted, posture_[i].weight);
  }
}

void InverseDynamics::AddFoot(std::size_t foot, const RigidBody& body, const FootTarget& target) {
  const bool stands = forces_.stands(foot);
  const FootKinematics& now = body.feet()[foot];
  Eigen::Vector3d a_WF = -kStandDamping_per_s * now.v_WF;
  // A sole is drawn flat, whichever way it faces: that is the ground's to hold.
  Eigen::Vector3d wdot_WF =
      kStandStiffness_per_s2 * (now.R_WF * UprightError_B(Eigen::Quaterniond(now.R_WF))) -
      kStandDamping_per_s * now.w_WF;
  if (!stands) {
    a_WF = TrackedAcceleration({target.p_WF, target.v_WF, target.a_WF}, now.p_WF, now.v_WF,
                               params_.swing_stiffness_per_s2, params_.swing_damping_per_s);
    wdot_WF =
        params_.swing_rotation_stiffness_per_s2 * RotationError_W(now.R_WF, target.contact.R_WF) -
        params_.swing_rotation_damping_per_s * now.w_WF;
  }
  const FootTask task = FootAcceleration(body, foot, a_WF, wdot_WF);
  const double hold = forces_.hold(foot);
  qp_.AddTask(task.linear, stands ? hold * params_.stand_weight : params_.swing_weight);
  if (!is_flat_[foot]) return;
  qp_.AddTask(task.angular,
              stands ? hold * params_.stand_rotation_weight : params_.swing_rotation_weight);
}

}  // namespace sidestep::wbc
