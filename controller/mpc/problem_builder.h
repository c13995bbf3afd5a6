// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// problem_builder: from belief, contact plan and references to a CentroidalOcp.
//
// Knot k lies at tick + k T. A planned contact [start, end) is active at the knots nearest to its
// ends (Gamma sampling); on a schedule that is a multiple of T from the solve this is exact.

#include <Eigen/Core>
#include <vector>

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/types/contact_plan.h"
#include "controller/types/gravity.h"
#include "controller/types/mpc_params.h"
#include "controller/types/robot_state.h"
#include "controller/types/tick.h"

namespace sidestep::mpc {

/// What the builder must know of the robot.
struct RobotModel {
  double mass_kg{1.0};
  Eigen::Vector3d gravity_mps2{0.0, 0.0, -kGravity_mps2};
  std::vector<std::string> foot_names;
  std::vector<Eigen::Matrix3Xd> vertices_m;   ///< One a foot, 3 x n_v, in F.
  std::vector<Eigen::VectorXd> force_shares;  ///< One a foot, as OcpContact's; none: all equal.
};

/// References sampled on the grid, N+1 columns each.
struct GridReferences {
  Eigen::Matrix3Xd p_WC;              ///< m.
  Eigen::Matrix3Xd angular_momentum;  ///< kg m^2/s.
};

/// Owns the one problem and rewrites it in place. What does not change from solve to solve
/// (weights, pyramid, vertices, mass) is set by the constructor; phases have room for one a knot.
class ProblemBuilder {
 public:
  /// `tick_s` is the length of a tick (s); params.step_s is a whole number of them.
  ProblemBuilder(const MpcParams& params, const RobotModel& robot, double tick_s);

  /// Fills the problem at `tick`. Shapes change only with the contact schedule.
  const CentroidalOcp& Build(const RobotState& state, const ContactPlan& plan,
                             const GridReferences& references, Tick tick);

  /// The planned contact's index behind phase `phase` of contact `foot` of the last problem.
  int PlannedIndex(std::size_t foot, std::size_t phase) const { return planned_[foot][phase]; }

  /// The last problem, for the previous force that only the solver's owner knows.
  CentroidalOcp& ocp() { return ocp_; }
  const CentroidalOcp& ocp() const { return ocp_; }

 private:
  /// A foot's planned contacts as phases of knots. One that has begun is fixed where it is; one
  /// that no knot falls into is left out.
  void FillPhases(std::size_t foot, const std::vector<PlannedContact>& planned, Tick tick);
  /// Constant for external_wrench_hold_s, then zero.
  void FillExternalWrench(const Wrench& wrench);

  MpcParams params_;
  Tick step_ticks_;  ///< Between knots.
  CentroidalOcp ocp_;
  std::vector<std::vector<int>> planned_;  ///< PlannedContact::index, by foot and phase.
};

}  // namespace sidestep::mpc
