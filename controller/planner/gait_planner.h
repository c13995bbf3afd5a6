// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_planner: the contacts and the CoM reference that the MPC sees at one instant.
//
// Holds the nominal gait and, with FollowMode::kCapturePoint, shifts what is still to come so that
// a robot that was pushed off its path steps on from where it is going, and drifts back to the path
// at no more than path_return_m a step. At each landing the shift becomes the capture point's
// distance from where the nominal motion would have it:
//   shift = (p_WC + v_WC / w) - (p_ref + v_ref / w),   w = sqrt(g / h)
// With FollowMode::kPath the gait stays where it is until steps are inserted (params.recovery);
// from then on the shift is how far from its nominal place a foot has landed. Source of the capture
// point: Pratt et al., "Capture point: a step toward humanoid push recovery", Humanoids 2006.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/planner/nominal_gait.h"
#include "controller/types/contact_plan.h"
#include "controller/types/robot_state.h"

namespace sidestep {

/// What the planner needs to insert steps that the gait does not have; see recovery.h.
struct RecoverySetup {
  std::vector<GaitParams> segments;  ///< As the nominal gait was built from.
  GaitGeometry geometry;
  Tick end_tick{0};  ///< The nominal gait is laid out until here.
  Tick grid{1};      ///< Steps begin at multiples of this.
  double mass_kg{1.0};
  std::vector<Eigen::Matrix3Xd> vertices_m;  ///< One 3 x n_v a foot, in F.
};

class GaitPlanner {
 public:
  /// `horizon` is how far contacts are planned ahead; `tick_s` one tick.
  GaitPlanner(NominalGait gait, const PlannerParams& params, Tick horizon, double tick_s);

  /// Lets the planner insert steps (params.recovery) when both feet stand and can't hold the robot.
  /// Takes the memory for as many as there is time for; Update() takes none.
  void EnableRecovery(const RecoverySetup& setup);

  /// Contacts that end after `tick` and begin before tick + horizon, for every foot; at
  /// least one a foot. Call with non-decreasing ticks. A contact that has begun is reported where
  /// the belief sees its foot.
  const ContactPlan& Update(const RobotState& state, Tick tick);

  /// Records the MPC's decision for contact `index` of `foot`, until the next one.
  void SetAdjusted(int foot, int index, const Eigen::Vector3d& p_WF);

  /// Nominal CoM motion at `tick`: quintic between the knots; shifted like the contacts.
  ComReference ReferenceAt(Tick tick) const { return Reference(tick, true); }

  const ContactPlan& plan() const { return plan_; }

 private:
  Eigen::Vector3d Shift(int sequence) const;
  void RecoverIfNeeded(const RobotState& state, Tick tick);
  bool StandsForNow(const RobotState& state, Tick tick) const;
  void KeepFeetApart(Tick tick);
  void NoteLandings(const RobotState& state, Tick tick);
  static Eigen::Vector3d Displacement(const PlannedContact& landed);
  Eigen::Vector3d CapturePointError(const RobotState& state, Tick tick) const;
  ComReference KnotState(std::size_t at, bool shifted) const;
  ComReference Reference(Tick tick, bool shifted) const;

  NominalGait gait_;
  PlannerParams params_;
  Tick horizon_;
  double tick_s_;
  std::vector<std::size_t> first_;      // first contact of each foot that has not ended
  std::vector<std::size_t> landed_;     // contacts of each foot known to have begun
  std::vector<Eigen::Vector3d> shift_;  // by landing sequence, up to last_landing_
  int last_landing_{0};
  std::optional<RecoverySetup> recovery_;
  bool has_recovered_{false};  // the path begins where the recovery led
  ContactPlan plan_;
};

}  // namespace sidestep
