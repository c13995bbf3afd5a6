// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// timing_choice: when a pushed walk steps and with which foot, chosen by what the MPC makes of it.
//
//   state, planner ──► candidates (planner/timing_candidates.h) ──► MPC's cost of each ──► support
//
// The mixed problem, contacts on or off at every knot, is left to a list of a dozen courses and a
// solve of each: deterministic, and silent unless somebody pushes (push_alarm.h). Then a linear
// pendulum tells whether it matters: the capture point's distance from its nominal place. The path
// that it is measured against is the shifted one and the one it was before it shifted, whichever is
// farther: after the first step the robot is where it steps, and the second step decides.

#include <optional>
#include <vector>

#include "controller/grid_references.h"
#include "controller/mpc/centroidal_mpc.h"
#include "controller/planner/gait_planner.h"
#include "controller/planner/timing_candidates.h"
#include "controller/push_alarm.h"

namespace sidestep {

class TimingChoice {
 public:
  /// @param com_height_m  Of the nominal CoM above the ground. @param tick_s  One tick.
  TimingChoice(const TimingParams& params, const MpcParams& mpc, double com_height_m,
               double mass_kg, double tick_s);

  /// The course to go on with from `tick` on, or nothing: as the gait has it. `momentum` as for
  /// SampleReferences. Solves with `mpc`, and changes none of its plans.
  std::optional<GaitSupport> Choose(const RobotState& state, const GaitPlanner& planner,
                                    const Eigen::Vector3d& momentum, Tick tick,
                                    mpc::CentroidalMpc* mpc);

 private:
  /// Before the first push, all that courses need.
  void TakeMemory(const GaitPlanner& planner);
  /// How far (m) the capture point is off.
  double ErrorOf(const RobotState& state, const GaitPlanner& planner, Tick tick) const;
  /// What the MPC makes of a course, as CentroidalMpc::CostOf() has it.
  double CostOf(const RobotState& state, const ContactSchedule& schedule, const ContactPlan& plan,
                const Eigen::Vector3d& momentum, Tick tick, double ceiling,
                mpc::CentroidalMpc* mpc);

  TimingParams params_;
  MpcParams mpc_params_;
  TimingLimits limits_;
  double com_height_m_;
  PushAlarm alarm_;
  double tick_s_;
  std::vector<GaitSupport> candidates_;  // scratch, as the rest
  ContactSchedule schedule_;
  ContactPlan plan_;
  mpc::GridReferences references_;
};

}  // namespace sidestep
