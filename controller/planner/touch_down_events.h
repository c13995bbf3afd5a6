// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// touch_down_events: a foot that lands before or after its time moves the schedule.
//
// The gait's clock says when a foot is due; the ground says when it is there. A foot that bears
// weight on its way down stands from now on, and all that comes after is as much earlier. One that
// is due and not felt is waited for, for a bounded time: the foot that stands goes on standing, and
// all that comes after is as much later. Once it counts as standing the same holds for the foot
// that would leave it alone while it is not felt: it puts off its lift-off, for a bounded time.

#include <optional>

#include "controller/planner/gait_setup.h"
#include "controller/planner/gait_support.h"
#include "controller/types/robot_state.h"
#include "controller/types/tick.h"

namespace sidestep {

/// By default nothing is an event: the clock decides.
struct TouchDownRule {
  bool is_felt{false};       ///< Contact with the ground decides.
  double early_load_N{0.0};  ///< A swinging foot that bears more has landed.
  Tick longest_wait{0};      ///< For a foot that is due; for one that stands, once more.
  Tick period{1};            ///< From one look at the feet to the next, >= 1.
};

/// The same support with its next landing moved to `tick`, or just beyond it; none if there is no
/// event at `tick`, or the schedule can't be changed for it. A foot before the middle of its swing
/// does not land: it may not have left yet.
std::optional<GaitSupport> AfterTouchDownEvent(const GaitSetup& setup, const GaitSupport& support,
                                               const RobotState& state, Tick tick,
                                               const TouchDownRule& rule);

/// The same support with the lift-off that is due at `tick` put off to the next look at the feet,
/// and all that comes after it; none unless it would leave the robot on a foot that is not felt. A
/// gait whose double support is shorter than the rule's period has no time to give.
std::optional<GaitSupport> AfterHeldLiftOff(const GaitSetup& setup, const GaitSupport& support,
                                            const RobotState& state, Tick tick,
                                            const TouchDownRule& rule);

}  // namespace sidestep
