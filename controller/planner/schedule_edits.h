// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// schedule_edits: the same gait, but another course of things from now on.
//
// Each edit takes where the gait is and gives where it would be with that edit, or nothing if it
// can't be; GenerateSchedule() (or GaitPlanner::LayOut) of that is the edited schedule, and
// GaitPlanner::Adopt goes on from it. What has happened by `now` stays: contacts that have ended,
// feet in the air, knots that the CoM has passed. Values in, values out: deterministic, no memory
// taken, edits can be chained and compared.
//
// `now` lies in `support`: support.tick <= now, before the next support's (ContractViolation).
// Segments go by their start_s: an edit that moves a touch-down over one lets that one begin there.

#include <optional>

#include "controller/planner/gait_setup.h"
#include "controller/planner/gait_support.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"

namespace sidestep {

/// The touch-down of landing `move.sequence` comes `move.by` ticks later (or earlier), on top of
/// what it was moved before, and all that follows moves along. Its foot lifts off as before.
/// None if it has landed, is no step to come (or not among the next 16, or more than 4 are moved),
/// would land by `now` or by the landing before it, be in the air for less than `least_swing`
/// ticks, or overlap: land before the other foot of a run has left.
std::optional<GaitSupport> MoveTouchDown(const GaitSetup& setup, const GaitSupport& support,
                                         Tick now, const TouchDownMove& move, Tick least_swing);

/// Brings the feet side by side by the fewest steps and stands from then on, segments or not. A
/// foot in the air lands when it would have, beside the one that stands; of a run it lands by the
/// gait's swing_s, unless neither foot is on the ground: then that landing comes first.
GaitSupport StopNow(const GaitSetup& setup, const GaitSupport& support, Tick now);

/// From standing, `gait` begins now with `first_foot` in the place of all segments. None unless all
/// feet stand side by side, and it is a gait for that many feet with steps of 20 ms or more.
std::optional<GaitSupport> StartNow(const GaitSetup& setup, const GaitSupport& support, Tick now,
                                    const GaitParams& gait, int first_foot);

/// Walking steps on the spot.
struct RecoverySteps {
  int steps{1};
  double swing_s{0.4};
  double double_support_s{0.1};
  int first_foot{0};
};

/// Makes those steps now, then lets the gait go on. A step whose foot is in the air lands first.
/// None if the robot has not two feet, there are no steps or they are shorter than 20 ms, or the
/// first foot would have to leave while it alone is on the ground.
std::optional<GaitSupport> StepOnTheSpot(const GaitSetup& setup, const GaitSupport& support,
                                         Tick now, const RecoverySteps& recovery);

}  // namespace sidestep
