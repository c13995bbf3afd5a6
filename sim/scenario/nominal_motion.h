// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nominal_motion: the gait that a scenario asks for, as contacts and CoM motion over the whole run.
//
// In : the gait that is asked for (AskedGait), the robot's feet and heights.
// Out: what a run is measured against. It is laid out once, from the scenario alone: nothing that a
//      controller does or thinks moves it.
// Pure data: const after construction, copied as a value.

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "controller/planner/nominal_gait.h"
#include "controller/types/contact_plan.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"
#include "models/robot_description/robot_description.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// What a robot is asked to do, whoever controls it.
/// `sway` is spelled `control.planner.sway` and `com_sway`, for robots give them their own defaults
/// there, but how far the CoM is to go to the side is asked of the robot and no choice of its
/// controller: nothing else of `control:` moves the yardstick. What changes with it are the figures
/// that look at the CoM's path across its way (path error, drift, recovery); footholds do not.
struct AskedGait {
  std::vector<GaitParams> segments;  ///< In order of start_s, the first at 0.
  ComSway sway;                      ///< PlannerParams::sway.
  double duration_s{0.0};
  double tick_s{0.001};  ///< Length of a tick.
};

AskedGait AskedGaitOf(const Scenario& scenario);

/// The number of the one of `starts` (ascending, not empty) that is nearest to `tick`; the earlier
/// of two as near.
std::size_t NearestStart(std::span<const Tick> starts, Tick tick);

class NominalMotion {
 public:
  /// Lays the gait out over its duration and a few seconds more. Throws ContractViolation without
  /// segments or without feet.
  NominalMotion(const RobotDescription& robot, const AskedGait& asked);

  /// Nominal CoM at `tick` (m, m/s, m/s^2; W); at rest in its first place before tick 0.
  ComReference ComAt(Tick tick) const;

  std::size_t num_feet() const { return feet_.size(); }

  /// Contacts of a foot, by increasing start; number 0 is where it stands at the start. In each,
  /// adjusted_p_WF is nominal_p_WF, and the box is empty: a box is the controller's. A last one
  /// that has no end ends no earlier than end_tick().
  const std::vector<PlannedContact>& contacts(std::size_t foot) const { return feet_.at(foot); }

  /// When they start.
  const std::vector<Tick>& starts(std::size_t foot) const { return starts_.at(foot); }

  /// The step to contact `index` of `foot` (m; W): its place less that of the other foot's contact
  /// that began last before or with it. For a single foot: less that of its previous contact; zero
  /// for its first.
  Eigen::Vector3d StepTo(std::size_t foot, std::size_t index) const;

  /// Until here the gait is laid out.
  Tick end_tick() const { return end_tick_; }

  double tick_s() const { return tick_s_; }

 private:
  double tick_s_;
  Tick end_tick_;
  NominalGait gait_;
  std::vector<std::vector<PlannedContact>> feet_;
  std::vector<std::vector<Tick>> starts_;  // of feet_
};

}  // namespace sidestep
