// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/inverse_kinematics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/wbc/com_zmp_correction.h"
#include "controller/wbc/rotation.h"
#include "controller/wbc/tasks.h"
#include "models/support/require.h"

namespace sidestep::wbc {
namespace {

constexpr double kSoftComWeight = 1e2;    // when the hard tasks contradict each other
constexpr double kBaseDamping = 1e-6;     // of a base twist that no task asks for
constexpr double kMinCarriedShare = 0.1;  // of the weight, for a ZMP worth believing

// A sole that the ground has turned about z is not turned back as it stands: friction would hold it
// and turn the robot instead, and the commanded robot would move about it as the true one does not.
bool GivesWay(const InverseKinematicsParams& params) {
  return params.foot_moment_compliance_radps_per_Nm > 0.0;
}

DenseQpDimensions Maxima(const RobotDescription& robot, const RigidBody& body) {
  const int foot_rows = body.num_base_velocities();  // as many ways as the base has to move
  const int com_rows = body.base().num_linear();
  return {body.num_velocities(), foot_rows * static_cast<int>(robot.feet.size()) + com_rows,
          body.num_actuators()};
}

}  // namespace

InverseKinematics::InverseKinematics(const RobotDescription& robot,
                                     const InverseKinematicsParams& params, double dt_s)
    : robot_(robot),
      params_(params),
      dt_s_(dt_s),
      body_(robot),
      nv_(body_.num_velocities()),
      holds_(robot.feet.size()),
      deflection_(robot, dt_s),
      qp_(Maxima(robot, body_)),
      solver_(Maxima(robot, body_)) {
  SIDESTEP_REQUIRE(robot.joints.size() == static_cast<std::size_t>(body_.num_actuators()),
                   robot.joints.size());
  for (const FootDescription& foot : robot.feet) vertices_m_.push_back(foot.vertices_m);
  commanded_.feet.resize(robot.feet.size());
  body_.WriteHome(&commanded_);
  home_ = commanded_.joint_position;
  nu_.setZero(nv_);
}

std::unique_ptr<WholeBody> InverseKinematics::Clone() const {
  return std::make_unique<InverseKinematics>(*this);
}

Eigen::Index InverseKinematics::Joint(std::size_t actuator) const {
  return body_.actuated_velocity()[actuator];
}

WbcReport InverseKinematics::Solve(const RobotState& state, const RigidBody& body,
                                   const ComTarget& com, const std::vector<FootTarget>& feet,
                                   ActuatorCommand* command) {
  if (!started_) Start(state);
  Anchor(state, body);
  body_.Update(commanded_);
  const double min_force_N = kMinCarriedShare * body_.mass_kg() * body_.gravity_mps2().norm();
  const Eigen::Vector3d v_WC = CorrectedComVelocity(
      params_, state, com, PlannedZeroMomentPoint(feet, vertices_m_, min_force_N),
      ZeroMomentPoint(state.feet, min_force_N));
  Build(v_WC, state, feet);

  const DenseQpSolution* solution = &solver_.Solve(qp_.View());
  const bool ok = solution->status == QpStatus::kSolved;
  if (!ok) {  // feet first, the CoM as well as it goes
    qp_.DropEqualities(body_.base().num_linear());
    qp_.AddTask(ComVelocity(body_, v_WC), kSoftComWeight);
    solution = &solver_.Solve(qp_.View());
  }
  if (solution->status == QpStatus::kSolved) {
    nu_ = solution->x;
  } else {
    nu_.setZero();
  }
  Integrate(nu_);

  command->torque_Nm.resize(0);
  command->joint_position = commanded_.joint_position;
  command->joint_velocity = commanded_.joint_velocity;
  if (params_.compensates_deflection) {  // at the tick's start: torques change little in one
    command->joint_position += deflection_.Update(body_, feet);
  }
  return {solution->status, ok, solution->iterations};
}

void InverseKinematics::Start(const RobotState& state) {
  commanded_.p_WB = state.p_WB;
  commanded_.q_WB = state.q_WB;
  commanded_.joint_position = state.joint_position;
  commanded_.joint_velocity.setZero();
  body_.Update(commanded_);
  for (std::size_t i = 0; i < holds_.size(); ++i) holds_[i] = {true, body_.feet()[i].p_WF};
  started_ = true;
}

// Moves the commanded robot as a whole towards the belief: attitude about its standing feet, then
// position. The joints, which are all that the servos see, do not notice. The model still is where
// the last tick began: to first order its feet have moved since as that tick's twist says. Where a
// waist is between base and legs it is brought up to date.
void InverseKinematics::Anchor(const RobotState& state, const RigidBody& believed) {
  const bool has_waist = body_.has_waist();
  if (has_waist) body_.Update(commanded_);
  Eigen::Vector3d p_cmd = Eigen::Vector3d::Zero(), p_believed = Eigen::Vector3d::Zero();
  int standing = 0;
  for (std::size_t i = 0; i < holds_.size(); ++i) {
    if (!holds_[i].active || !state.feet[i].in_contact) continue;
    if (has_waist) {
      p_cmd += body_.feet()[i].p_WF;
    } else {
      p_cmd += body_.feet()[i].p_WF + dt_s_ * (body_.foot_jacobian(i).J * nu_);
    }
    p_believed += state.feet[i].p_WF;
    ++standing;
  }
  if (standing == 0) return;
  p_cmd /= standing;
  p_believed /= standing;
  const double turn_share = std::min(1.0, params_.attitude_anchor_per_s * dt_s_);
  const double shift_share = std::min(1.0, params_.position_anchor_per_s * dt_s_);
  const Eigen::Vector3d turn =
      turn_share * (has_waist ? RotationError_W(body_.leg_root_R_W(), believed.leg_root_R_W())
                              : RotationError_W(commanded_.q_WB.toRotationMatrix(),
                                                state.q_WB.toRotationMatrix()));
  const Eigen::Quaterniond rotation = FromRotationVector(turn);
  const Eigen::Vector3d shift = shift_share * (p_believed - p_cmd);
  commanded_.q_WB = (rotation * commanded_.q_WB).normalized();
  commanded_.p_WB = p_cmd + rotation * (commanded_.p_WB - p_cmd) + shift;
  for (Hold& hold : holds_) hold.p_WF.head<2>() += shift.head<2>();
}

// The list of tasks: exact ones, the CoM last among them, then weighted ones.
void InverseKinematics::Build(const Eigen::Vector3d& v_WC, const RobotState& state,
                              const std::vector<FootTarget>& feet) {
  qp_.Start(nv_);
  GiveWay(params_, state, feet, vertices_m_, &yielding_);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const bool has_landed = holds_[i].active || state.feet[i].in_contact;
    AddFoot(i, feet[i], feet[i].planned_contact && has_landed);
  }
  qp_.AddExact(ComVelocity(body_, v_WC), body_.base().linear_axes());
  if (body_.has_torso()) AddTrunk(feet);
  AddPosture();
  AddJointLimits();
}

// A standing foot is held where it was commanded when it landed, flat and at the sole's height; a
// swinging one follows its target.
void InverseKinematics::AddFoot(std::size_t foot, const FootTarget& target, bool stands) {
  const FootKinematics& at = body_.feet()[foot];
  Hold& hold = holds_[foot];
  if (stands && !hold.active) hold.p_WF = at.p_WF;
  hold.active = stands;
  hold.p_WF.z() = robot_.feet[foot].sole_height_m;
  const Eigen::Vector3d p_WF = stands ? hold.p_WF : target.p_WF;
  const Eigen::Vector3d feedforward = stands ? Eigen::Vector3d::Zero().eval() : target.v_WF;
  const FootYielding gives = stands ? yielding_[foot] : FootYielding{};
  const Eigen::Vector3d v_WF = feedforward + gives.lift_mps * Eigen::Vector3d::UnitZ() +
                               params_.foot_linear_gain_per_s * (p_WF - at.p_WF);
  Eigen::Vector3d w_WF =
      params_.foot_angular_gain_per_s * RotationError_W(at.R_WF, target.contact.R_WF);
  if (stands && GivesWay(params_)) w_WF.z() = 0.0;
  const FootTask task = FootVelocity(body_, foot, v_WF, w_WF + gives.w_WF);
  qp_.AddExact(task.linear, body_.base().linear_axes());
  if (stands || params_.swing_attitude_weight == 0.0) {
    qp_.AddExact(task.angular, body_.base().angular_axes());
  } else {
    qp_.AddTask(task.angular, params_.swing_attitude_weight, body_.base().angular_axes());
  }
}

// Upright, facing where the feet face on average: where they are to, or, if they give way, do.
void InverseKinematics::AddTrunk(const std::vector<FootTarget>& feet) {
  const Eigen::Matrix3d upright =
      GivesWay(params_) ? UprightFacingAs(body_) : UprightFacingAs(feet);
  const Eigen::Vector3d w_WT =
      params_.torso_gain_per_s * RotationError_W(body_.torso().R_WT, upright);
  qp_.AddTask(TrunkVelocity(body_, w_WT), params_.torso_weight);
}

void InverseKinematics::AddPosture() {
  for (int i = 0; i < body_.num_base_velocities(); ++i) qp_.AddDiagonal(i, 0.0, kBaseDamping);
  for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double weight = params_.posture_weight * robot_.joints[i].posture_weight;
    const double target = params_.posture_gain_per_s * (home_[at] - commanded_.joint_position[at]);
    qp_.AddDiagonal(Joint(i), target, weight);
  }
}

// A joint may use what is left to its limit within a few ticks, and no more than its speed.
void InverseKinematics::AddJointLimits() {
  const double approach_per_s = 0.2 / dt_s_;
  InequalityRows rows = qp_.AddInequalities(body_.num_actuators());
  for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double q = commanded_.joint_position[at];
    const double limit = robot_.joints[i].velocity_limit_radps;
    const double down = approach_per_s * (body_.joint_lower()[at] - q);
    const double up = approach_per_s * (body_.joint_upper()[at] - q);
    rows.C(at, Joint(i)) = 1.0;
    rows.lower[at] = std::clamp(down, -limit, limit);
    rows.upper[at] = std::clamp(up, -limit, limit);
  }
}

void InverseKinematics::Integrate(const Eigen::VectorXd& nu) {
  const Vector6 twist = body_.base().Spread(nu);
  commanded_.v_WB = twist.head<3>();
  commanded_.w_WB_B = twist.tail<3>();
  commanded_.p_WB += dt_s_ * commanded_.v_WB;
  commanded_.q_WB = (commanded_.q_WB * FromRotationVector(dt_s_ * commanded_.w_WB_B)).normalized();
  for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    commanded_.joint_velocity[at] = nu[Joint(i)];
    commanded_.joint_position[at] += dt_s_ * nu[Joint(i)];
  }
}

}  // namespace sidestep::wbc
