// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/foot_compliance.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "controller/wbc/contact_forces.h"

namespace sidestep::wbc {
namespace {

constexpr double kFastestTurn_radps = 0.5;  // a sole's edge then moves as fast as a foot lands
constexpr double kFastestLift_mps = 0.1;
constexpr double kLeastShare = 0.05;  // of the load: less of a plan tells nothing of a pressure

// The moment about F that the plan's centre of pressure gives the force that is felt.
Eigen::Vector3d WantedMoment(const Eigen::Vector3d& force_N,
                             const Eigen::Matrix<double, 6, 1>& planned) {
  const Eigen::Vector3d p_FZ = Eigen::Vector3d(-planned[4], planned[3], 0.0) / planned[2];
  return p_FZ.cross(force_N);
}

}  // namespace

void GiveWay(const InverseKinematicsParams& params, const RobotState& state,
             const std::vector<FootTarget>& feet, const std::vector<Eigen::Matrix3Xd>& vertices_m,
             std::vector<FootYielding>* yielding) {
  yielding->assign(feet.size(), {});
  double planned_N = 0.0, felt_N = 0.0;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    planned_N += std::max(0.0, feet[i].vertex_force_N.row(2).sum());
    felt_N += std::max(0.0, state.feet[i].wrench.force_N.z());
  }
  if (planned_N <= 0.0 || felt_N <= 0.0) return;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const FootState& foot = state.feet[i];
    FootYielding& gives = (*yielding)[i];
    if (!feet[i].planned_contact) continue;
    const Eigen::Matrix<double, 6, 1> planned =
        FootWrench(feet[i].contact.R_WF, vertices_m[i], feet[i].vertex_force_N);
    const double share = std::max(0.0, planned[2]) / planned_N;
    const double surplus_N = foot.wrench.force_N.z() - share * felt_N;
    gives.lift_mps = std::clamp(params.foot_load_compliance_mps_per_N * surplus_N,
                                -kFastestLift_mps, kFastestLift_mps);
    if (!foot.in_contact || share < kLeastShare) continue;
    const Eigen::Vector3d surplus_Nm =
        foot.wrench.torque_Nm - WantedMoment(foot.wrench.force_N, planned);
    gives.w_WF.head<2>() = params.foot_moment_compliance_radps_per_Nm * surplus_Nm.head<2>();
    const double speed_radps = gives.w_WF.norm();
    if (speed_radps > kFastestTurn_radps) gives.w_WF *= kFastestTurn_radps / speed_radps;
  }
}

}  // namespace sidestep::wbc
