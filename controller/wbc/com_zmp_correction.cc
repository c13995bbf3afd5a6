// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/com_zmp_correction.h"

#include <Eigen/Geometry>

namespace sidestep::wbc {
namespace {

std::optional<Eigen::Vector2d> ZmpOf(const Eigen::Vector3d& force_N,
                                     const Eigen::Vector3d& moment_Nm, double min_force_N) {
  if (force_N.z() < min_force_N) return std::nullopt;
  return Eigen::Vector2d(-moment_Nm.y(), moment_Nm.x()) / force_N.z();
}

}  // namespace

std::optional<Eigen::Vector2d> ZeroMomentPoint(const std::vector<FootState>& feet,
                                               double min_force_N) {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment_Nm = Eigen::Vector3d::Zero();  // about W's origin
  for (const FootState& foot : feet) {
    force_N += foot.wrench.force_N;
    moment_Nm += foot.wrench.torque_Nm + foot.p_WF.cross(foot.wrench.force_N);
  }
  return ZmpOf(force_N, moment_Nm, min_force_N);
}

std::optional<Eigen::Vector2d> PlannedZeroMomentPoint(
    const std::vector<FootTarget>& feet, const std::vector<Eigen::Matrix3Xd>& vertices_m,
    double min_force_N) {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment_Nm = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const PlannedContact& contact = feet[i].contact;
    for (Eigen::Index v = 0; v < vertices_m[i].cols(); ++v) {
      const Eigen::Vector3d p_WV = contact.adjusted_p_WF + contact.R_WF * vertices_m[i].col(v);
      force_N += feet[i].vertex_force_N.col(v);
      moment_Nm += p_WV.cross(feet[i].vertex_force_N.col(v));
    }
  }
  return ZmpOf(force_N, moment_Nm, min_force_N);
}

Eigen::Vector3d CorrectedComVelocity(const InverseKinematicsParams& params, const RobotState& state,
                                     const ComTarget& com,
                                     const std::optional<Eigen::Vector2d>& planned_zmp,
                                     const std::optional<Eigen::Vector2d>& believed_zmp) {
  Eigen::Vector3d v_WC = com.v_WC + params.com_feedback_per_s * (com.p_WC - state.p_WC);
  if (planned_zmp && believed_zmp) {
    v_WC.head<2>() += params.zmp_feedback_per_s * (*believed_zmp - *planned_zmp);
  }
  return v_WC;
}

}  // namespace sidestep::wbc
