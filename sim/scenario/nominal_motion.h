// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nominal_motion: the gait that a scenario asks for, as contacts and CoM motion over the whole run.
//
// In : the scenario's `gait`, the robot's feet and heights, `control.planner.com_sway` and the
//      adjustment boxes of `control.mpc`.
// Out: what a run is measured against. It is laid out once, from the scenario alone: nothing that a
//      controller does or thinks moves it.
// Pure data: const after construction, copied as a value.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "controller/planner/nominal_gait.h"
#include "controller/types/contact_plan.h"
#include "controller/types/tick.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

class NominalMotion {
 public:
  /// Lays the gait out over the scenario's duration and a few seconds more. Throws
  /// ContractViolation for a scenario without gait or without feet.
  explicit NominalMotion(const Scenario& scenario);

  /// Nominal CoM at `tick` (m, m/s, m/s^2; W); at rest in its first place before tick 0.
  ComReference ComAt(Tick tick) const;

  std::size_t num_feet() const { return feet_.size(); }

  /// Contacts of a foot, by increasing start; number 0 is where it stands at the start. In each,
  /// adjusted_p_WF is nominal_p_WF. A last one that has no end ends no earlier than end_tick().
  const std::vector<PlannedContact>& contacts(std::size_t foot) const { return feet_.at(foot); }

  /// Number of the contact of `foot` whose start is nearest to `tick`; the earlier of two as near.
  std::size_t NearestContact(std::size_t foot, Tick tick) const;

  /// The step to contact `index` of `foot` (m; W): its place less that of the other foot's contact
  /// that began last before or with it. For a single foot: less that of its previous contact; zero
  /// for its first.
  Eigen::Vector3d StepTo(std::size_t foot, std::size_t index) const;

  /// Until here the gait is laid out.
  Tick end_tick() const { return end_tick_; }

 private:
  double tick_s_;
  Tick end_tick_;
  NominalGait gait_;
  std::vector<std::vector<PlannedContact>> feet_;
};

}  // namespace sidestep
