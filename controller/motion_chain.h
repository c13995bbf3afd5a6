// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// motion_chain: the links of the control chain that know no joints:
//
//   state -> schedule (planner) -> plan (MPC) -> feet (swing)
//
// With control.stepping dcm_qp or capture_point the second link is a DcmPlan instead.
//
// What is before it (an estimator) and after it (a whole-body control, or the bare forces) makes a
// controller of it; see locomotion_controller.cc and centroidal_controller.cc. Each link keeps its
// answer until its next call and reports to the stage timer.

#include <optional>
#include <string>
#include <vector>

#include "controller/controller.h"
#include "controller/dcm/dcm_plan.h"
#include "controller/mpc/centroidal_mpc.h"
#include "controller/planner/gait_planner.h"
#include "controller/swing/foot_targets.h"
#include "controller/timing_choice.h"

namespace sidestep {

class MotionChain {
 public:
  /// @param robot  What the MPC must know of the robot.
  /// @param rule   When a scheduled foot counts as standing.
  MotionChain(const ControllerSetup& setup, const mpc::RobotModel& robot, StandingRule rule);

  /// First link: contacts and CoM reference from `tick` on. Call every control tick.
  const ContactPlan& Schedule(const RobotState& state, Tick tick, StageTimer* timer);

  /// Whether the MPC solves at `tick`, for which Schedule() has been called: at its rate, and when
  /// a foot has landed before the plan in use has it.
  bool SolvesAt(Tick tick) const { return tick % mpc_period_ == 0 || planner_.has_landed_early(); }

  /// Second link: solves the MPC if it is due, after a pushed walk has chosen when to step, takes
  /// the newest plan that is old enough into use and hands its footholds back to the planner. Call
  /// every control tick.
  /// @param momentum  Angular momentum about C to follow from now on (kg m^2/s, in W): see
  ///                  momentum_reference.h. Read only where SolvesAt(tick).
  /// @return          CoM motion that the plan in use implies at `tick`; the nominal one as long as
  ///                  there is no plan, for the first solve failed.
  const ComTarget& Plan(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
                        StageTimer* timer);

  /// Third link: where the feet are meant to be, with the plan's forces on those that stand. Call
  /// every control tick.
  const std::vector<FootTarget>& TargetFeet(const RobotState& state, Tick tick, StageTimer* timer);

  /// For the log: writes what the three links decided for `tick->tick` into it.
  void WriteTo(ControlTick* tick) const;

  /// The last MPC problem as JSON; see Controller::LastProblemJson.
  std::string LastProblemJson(const std::string& name) const;

 private:
  /// The second link in the MPC's hands.
  void PlanByMpc(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
                 StageTimer* timer);
  /// In those of a baseline.
  void PlanByDcm(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
                 StageTimer* timer);

  MpcParams params_;
  double tick_s_;
  Tick mpc_period_;
  GaitPlanner planner_;
  mpc::CentroidalMpc mpc_;
  std::optional<dcm::DcmPlan> dcm_;  // in the place of mpc_ and timing_
  TimingChoice timing_;
  mpc::GridReferences references_;
  FootTargets foot_targets_;
  MpcReport report_;
  ComTarget com_;
  Eigen::Vector3d momentum_{Eigen::Vector3d::Zero()};  // Plan()'s last that counts, for dcm_
  std::vector<FootTarget> feet_;
};

}  // namespace sidestep
