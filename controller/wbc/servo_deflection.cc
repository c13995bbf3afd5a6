// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/servo_deflection.h"

#include <algorithm>

#include "controller/wbc/contact_forces.h"

namespace sidestep::wbc {
namespace {

constexpr double kSmoothing_s = 0.03;

}  // namespace

ServoDeflection::ServoDeflection(const RobotDescription& robot, double dt_s)
    : share_(dt_s / (kSmoothing_s + dt_s)) {
  for (const FootDescription& foot : robot.feet) vertices_m_.push_back(foot.vertices_m);
  const auto num_joints = static_cast<Eigen::Index>(robot.joints.size());
  stiffness_.setZero(num_joints);
  for (Eigen::Index i = 0; i < num_joints; ++i) {
    stiffness_[i] = robot.joints[static_cast<std::size_t>(i)].servo_stiffness_Nm_per_rad;
  }
  wrench_.assign(robot.feet.size(), Eigen::Matrix<double, 6, 1>::Zero());
  deflection_.setZero(num_joints);
}

const Eigen::VectorXd& ServoDeflection::Update(const RigidBody& body,
                                               const std::vector<FootTarget>& feet) {
  torque_ = body.bias();
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const Eigen::Matrix<double, 6, 1> planned =
        FootWrench(body.feet()[i].R_WF, vertices_m_[i], feet[i].vertex_force_N);
    const FrameJacobian& foot = body.foot_jacobian(i);
    wrench_[i] += (has_wrench_ ? share_ : 1.0) * (planned - wrench_[i]);
    torque_.noalias() -= foot.J.transpose() * wrench_[i].head<3>();
    torque_.noalias() -= foot.J_rot.transpose() * wrench_[i].tail<3>();
  }
  has_wrench_ = true;
  for (Eigen::Index i = 0; i < deflection_.size(); ++i) {
    const double limit_Nm = body.torque_limit_Nm()[i];
    const double torque_Nm = torque_[body.actuated_velocity()[static_cast<std::size_t>(i)]];
    deflection_[i] = std::clamp(torque_Nm, -limit_Nm, limit_Nm) / stiffness_[i];
  }
  return deflection_;
}

}  // namespace sidestep::wbc
