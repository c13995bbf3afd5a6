// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/joint_limits.h"

#include <algorithm>
#include <cmath>

namespace sidestep::wbc {
namespace {

// Rates at which a joint may near the end of its range and its greatest speed. The second is four
// times the first, which keeps the approach from overshooting, and below the control rate, beyond
// which a joint would be sent past its bound within a tick (200 Hz is the slowest that ships). At
// half of both the hopper's leg is late at the hips' ends.
constexpr double kSpeedShare = 0.95;  // of the speed limit: what a push adds within a tick
constexpr double kPositionRate_per_s = 40.0;
constexpr double kSpeedRate_per_s = 160.0;

// Room left where a bound gives way, above the QP's tolerance.
constexpr double kRoom = 1e-6;

}  // namespace

JointLimits::JointLimits(const RobotDescription& robot, const RigidBody& body) {
  const Eigen::Index actuators = body.num_actuators(), nv = body.num_velocities();
  speed_limit_.setConstant(actuators, kInfinity);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    speed_limit_[static_cast<Eigen::Index>(i)] = kSpeedShare * robot.joints[i].velocity_limit_radps;
  }
  lower_.setConstant(actuators, -kInfinity);
  upper_.setConstant(actuators, kInfinity);
  nudot_.setZero(nv);
  acting_.setZero(nv);
  torque_.setZero(nv);
  const int base = body.num_base_velocities();
  mass_.compute(Eigen::MatrixXd::Identity(nv, nv));  // takes its memory
  base_mass_.compute(Eigen::MatrixXd::Identity(base, base));
}

void JointLimits::Update(const RobotState& state, const RigidBody& body,
                         const BaseForce& external) {
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    const double limit = speed_limit_[i], q = state.joint_position[i];
    const double down = kPositionRate_per_s * (body.joint_lower()[i] - q);
    const double up = kPositionRate_per_s * (body.joint_upper()[i] - q);
    lower_[i] = kSpeedRate_per_s * (std::clamp(down, -limit, limit) - state.joint_velocity[i]);
    upper_[i] = kSpeedRate_per_s * (std::clamp(up, -limit, limit) - state.joint_velocity[i]);
  }
  GiveWay(body, external);
}

// The motion without forces at the feet whose joints accelerate least within the bounds; where that
// takes more torque than there is, the motion that the torques' limits leave of it.
void JointLimits::GiveWay(const RigidBody& body, const BaseForce& external) {
  acting_ = -body.bias();  // all that acts but the motors
  Eigen::Index row = 0;
  for (const int axis : body.base().axes()) acting_[row++] += external[axis];
  if (FindTorques(body)) return;
  torque_ += acting_;
  mass_.compute(body.mass_matrix());
  mass_.solveInPlace(torque_);  // now the accelerations
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    const double left = torque_[body.actuated_velocity()[static_cast<std::size_t>(i)]];
    const double room = kRoom * (1.0 + std::abs(left));
    lower_[i] = std::min(lower_[i], left - room);
    upper_[i] = std::max(upper_[i], left + room);
  }
}

// M nudot = acting + torque for joints that accelerate as little as they may: the base's rows give
// the base's acceleration, the others the torques.
bool JointLimits::FindTorques(const RigidBody& body) {
  const Eigen::MatrixXd& M = body.mass_matrix();
  const Eigen::Index base = body.num_base_velocities(), joints = body.num_velocities() - base;
  nudot_.setZero();
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    nudot_[body.actuated_velocity()[static_cast<std::size_t>(i)]] =
        std::clamp(0.0, lower_[i], upper_[i]);
  }
  nudot_.head(base) = acting_.head(base);
  nudot_.head(base).noalias() -= M.topRightCorner(base, joints) * nudot_.tail(joints);
  base_mass_.compute(M.topLeftCorner(base, base));
  auto base_acceleration = nudot_.head(base);
  base_mass_.solveInPlace(base_acceleration);
  torque_ = -acting_;
  torque_.noalias() += M * nudot_;
  torque_.head(base).setZero();  // but for rounding it is
  bool is_within = true;
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    double& torque_Nm = torque_[body.actuated_velocity()[static_cast<std::size_t>(i)]];
    const double limit_Nm = body.torque_limit_Nm()[i];
    is_within = is_within && std::abs(torque_Nm) <= limit_Nm;
    torque_Nm = std::clamp(torque_Nm, -limit_Nm, limit_Nm);
  }
  return is_within;
}

void JointLimits::AddTo(const RigidBody& body, QpBuilder* qp) const {
  InequalityRows rows = qp->AddInequalities(lower_.size());
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    rows.C(i, body.actuated_velocity()[static_cast<std::size_t>(i)]) = 1.0;
  }
  rows.lower = lower_;
  rows.upper = upper_;
}

}  // namespace sidestep::wbc
