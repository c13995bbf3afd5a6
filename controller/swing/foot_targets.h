// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// foot_targets: where every foot is meant to be now: on its foothold while it stands, on its swing
// while it flies, and on its way down while it should stand and bear and nothing is felt. One that
// has stood and bears nothing by plan waits for its lift-off where it is.
//
// In : contact plan and belief of this tick.     Out: FootTarget of every foot, but its forces.

#include <vector>

#include "controller/swing/swing_foot.h"
#include "controller/types/contact_plan.h"
#include "controller/types/control_tick.h"
#include "controller/types/robot_state.h"
#include "controller/types/tick.h"

namespace sidestep {

/// When a foot that the schedule has on the ground counts as standing there.
enum class StandingRule {
  kWhenFelt,     ///< While its contact is felt, dips apart; before and after it goes downwards.
  kAsScheduled,  ///< At once: the centroidal plant's feet are where the command puts them.
};

class FootTargets {
 public:
  /// A foot that is not felt for no longer than this still stands: on landing it may bounce.
  static constexpr double kLongestDip_s = 0.05;
  /// A foot with no more than this share of all planned vertical force is to bear nothing.
  static constexpr double kIdleShare = 0.02;

  FootTargets(std::size_t num_feet, StandingRule rule, double tick_s,
              const FloorSearch& search = {}, const SwingLimits& limits = {});

  /// Writes contact, planned_contact and motion of every foot; forces stay as they are, those of
  /// the last call. Every foot stands before the first one. Call every control tick with ascending
  /// ticks.
  /// @param plan  The current or next contact of each foot comes first.
  /// @param feet  One a foot, those of the last call.
  void Update(const RobotState& state, const ContactPlan& plan, Tick tick,
              std::vector<FootTarget>* feet);

 private:
  struct Foot {
    SwingFoot swing;
    bool has_landed{true};  // in its contact
    Tick felt_tick{0};      // where it was last felt in it
  };

  void UpdateFoot(const FootState& state, bool is_idle, Tick tick, Foot* foot,
                  FootTarget* target) const;

  StandingRule rule_;
  Tick longest_dip_;
  std::vector<Foot> feet_;
};

}  // namespace sidestep
