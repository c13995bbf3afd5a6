// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/joint_limits.h"

#include <Eigen/LU>
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

// The base's block of the mass matrix. Takes no memory.
using BaseMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

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
  generalised_.setZero(nv);
  mass_.compute(Eigen::MatrixXd::Identity(nv, nv));  // takes its memory
}

void JointLimits::Update(const RobotState& state, const RigidBody& body,
                         const BaseVector& external) {
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
// takes more torque than there is, the motion that the torque's limits leave of it.
void JointLimits::GiveWay(const RigidBody& body, const BaseVector& external) {
  const Eigen::MatrixXd& M = body.mass_matrix();
  const Eigen::Index nb = body.num_base_velocities();
  const Eigen::Index joints = body.num_velocities() - nb;
  nudot_.setZero();
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    nudot_[body.actuated_velocity()[static_cast<std::size_t>(i)]] =
        std::clamp(0.0, lower_[i], upper_[i]);
  }
  const BaseVector base_rows = external - body.bias().head(nb) -
                               M.topRightCorner(nb, joints).lazyProduct(nudot_.tail(joints));
  const BaseMatrix M_base = M.topLeftCorner(nb, nb);
  nudot_.head(nb) = M_base.llt().solve(base_rows);
  generalised_ = body.bias();
  generalised_.noalias() += M * nudot_;
  bool is_within = true;
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    double& torque_Nm = generalised_[body.actuated_velocity()[static_cast<std::size_t>(i)]];
    const double limit_Nm = body.torque_limit_Nm()[i];
    is_within = is_within && std::abs(torque_Nm) <= limit_Nm;
    torque_Nm = std::clamp(torque_Nm, -limit_Nm, limit_Nm);
  }
  if (is_within) return;
  generalised_.head(nb) = external;
  generalised_ -= body.bias();
  mass_.compute(M);
  mass_.solveInPlace(generalised_);  // now the accelerations
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    const double left = generalised_[body.actuated_velocity()[static_cast<std::size_t>(i)]];
    const double room = kRoom * (1.0 + std::abs(left));
    lower_[i] = std::min(lower_[i], left - room);
    upper_[i] = std::max(upper_[i], left + room);
  }
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
