// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// problem_builder: from belief, contact plan and references to a CentroidalOcp.
//
// Knots lie on the plan's grid (knot_grid.h). A planned contact [start, end) is active from the
// knot nearest to its start to the one nearest to its end (Gamma sampling): exact for what changes
// on the grid, whenever the solve is.

#include <Eigen/Core>
#include <vector>

#include "controller/mpc/knot_grid.h"
#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/types/contact_plan.h"
#include "controller/types/mpc_params.h"
#include "controller/types/robot_state.h"
#include "controller/types/tick.h"
#include "models/support/gravity.h"

namespace sidestep::mpc {

/// What the builder must know of the robot.
struct RobotModel {
  double mass_kg{1.0};
  Eigen::Vector3d gravity_mps2{0.0, 0.0, -kGravity_mps2};
  std::vector<std::string> foot_names;
  std::vector<Eigen::Matrix3Xd> vertices_m;   ///< One a foot, 3 x n_v, in F.
  std::vector<LegReach> legs;                 ///< One a foot, stretched; none: not known.
  std::vector<Eigen::VectorXd> force_shares;  ///< One a foot, as OcpContact's; none: all equal.
};

/// References sampled at the knots of ProblemBuilder::GridAt(), N+1 columns each.
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

  /// The knots of a problem that is built at `tick` for `plan`.
  KnotGrid GridAt(const ContactPlan& plan, Tick tick) const {
    return {tick, plan.grid_tick, step_ticks_};
  }

  /// Fills the problem at `tick`. Shapes change only with the contact schedule.
  const CentroidalOcp& Build(const RobotState& state, const ContactPlan& plan,
                             const GridReferences& references, Tick tick);

  /// The knots of the last problem.
  const KnotGrid& grid() const { return grid_; }

  /// The planned contact's index behind phase `phase` of contact `foot` of the last problem.
  int PlannedIndex(std::size_t foot, std::size_t phase) const { return planned_[foot][phase]; }

  /// The last problem, for the previous force that only the solver's owner knows.
  CentroidalOcp& ocp() { return ocp_; }
  const CentroidalOcp& ocp() const { return ocp_; }

 private:
  /// A foot's planned contacts as phases of knots. One that has begun is fixed where it is; one
  /// that no knot falls into is left out.
  void FillPhases(std::size_t foot, const std::vector<PlannedContact>& planned);
  /// Constant for external_wrench_hold_s, then fading with external_wrench_decay_s.
  void FillExternalWrench(const Wrench& wrench);

  MpcParams params_;
  double tick_s_;
  Tick step_ticks_;  ///< T.
  KnotGrid grid_;
  CentroidalOcp ocp_;
  std::vector<std::vector<int>> planned_;  ///< PlannedContact::index, by foot and phase.
};

}  // namespace sidestep::mpc
