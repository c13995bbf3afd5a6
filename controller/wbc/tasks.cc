// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/tasks.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sidestep::wbc {
namespace {

Eigen::Matrix3d UprightFacing(const Eigen::Vector3d& forward) {
  const double yaw_rad = std::atan2(forward.y(), forward.x());
  return Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace

Task ComVelocity(const RigidBody& body, const Eigen::Vector3d& v_WC) {
  return {body.com_jacobian(), v_WC};
}

Task ComAcceleration(const RigidBody& body, const Eigen::Vector3d& a_WC) {
  return {body.com_jacobian(), a_WC - body.com_bias_mps2()};
}

Task AngularMomentum(const RigidBody& body, const Eigen::Vector3d& h_C_W) {
  return {body.angular_momentum_jacobian(), h_C_W};
}

Task AngularMomentumRate(const RigidBody& body, const Eigen::Vector3d& moment_C_W) {
  return {body.angular_momentum_jacobian(), moment_C_W - body.angular_momentum_bias_Nm()};
}

FootTask FootVelocity(const RigidBody& body, std::size_t foot, const Eigen::Vector3d& v_WF,
                      const Eigen::Vector3d& w_WF) {
  const FrameJacobian& jacobian = body.foot_jacobian(foot);
  return {{jacobian.J, v_WF}, {jacobian.J_rot, w_WF}};
}

Task FootLinearAcceleration(const RigidBody& body, std::size_t foot, const Eigen::Vector3d& a_WF) {
  return {body.foot_jacobian(foot).J, a_WF - body.foot_bias(foot).linear_mps2};
}

FootTask FootAcceleration(const RigidBody& body, std::size_t foot, const Eigen::Vector3d& a_WF,
                          const Eigen::Vector3d& wdot_WF) {
  return {FootLinearAcceleration(body, foot, a_WF),
          {body.foot_jacobian(foot).J_rot, wdot_WF - body.foot_bias(foot).angular_radps2}};
}

Task TrunkVelocity(const RigidBody& body, const Eigen::Vector3d& w_WT) {
  return {body.torso_jacobian(), w_WT};
}

Task TrunkAcceleration(const RigidBody& body, const Eigen::Vector3d& wdot_WT) {
  return {body.torso_jacobian(), wdot_WT - body.torso_bias_radps2()};
}

Eigen::Matrix3d UprightFacingAs(const std::vector<FootTarget>& feet) {
  Eigen::Vector3d forward = Eigen::Vector3d::Zero();
  for (const FootTarget& foot : feet) forward += foot.contact.R_WF.col(0);
  return UprightFacing(forward);
}

Eigen::Matrix3d UprightFacingAs(const RigidBody& body) {
  Eigen::Vector3d forward = Eigen::Vector3d::Zero();
  for (const FootKinematics& foot : body.feet()) forward += foot.R_WF.col(0);
  return UprightFacing(forward);
}

Eigen::Vector3d TrackedAcceleration(const PointTarget& target, const Eigen::Vector3d& p_now,
                                    const Eigen::Vector3d& v_now, double stiffness_per_s2,
                                    double damping_per_s) {
  return target.a + stiffness_per_s2 * (target.p - p_now) + damping_per_s * (target.v - v_now);
}

}  // namespace sidestep::wbc
