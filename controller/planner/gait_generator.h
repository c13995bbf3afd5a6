// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_generator: from where a gait is now, the contacts and the CoM's knots of a horizon ahead.
//
// Pure functions over values, deterministic. Who keeps a GaitSupport and takes NextSupport() of it
// at each touch-down walks along the gait; nothing knows how long the episode lasts. To ask for
// another course of things edit the support first (schedule_edits.h).

#include <optional>

#include "controller/planner/contact_schedule.h"
#include "controller/planner/gait_setup.h"
#include "controller/planner/gait_support.h"
#include "controller/types/tick.h"

namespace sidestep {

/// At tick 0: all feet on the ground, side by side at the path's begin.
/// Throws ContractViolation without segments.
GaitSupport StandingSupport(const GaitSetup& setup);

/// The support that `support` leads to, from its `tick` on. None: it stands for good.
std::optional<GaitSupport> NextSupport(const GaitSetup& setup, const GaitSupport& support);

/// Writes to `schedule` the contacts of every foot that end after `tick` and begin no later than
/// tick + horizon, at least one a foot, and the CoM's knots: NominalComAt() is exact from `tick` to
/// tick + horizon. Ends are known, also beyond the horizon, but of feet that stand for good.
/// Nominal places: no shift is added. Contacts that have begun are as in `support`.
/// Takes memory the first time that it writes to `schedule`, none after (same setup and horizon).
/// @param support  The one that `tick` lies in: support.tick <= tick, before the next one's.
void GenerateSchedule(const GaitSetup& setup, const GaitSupport& support, Tick tick, Tick horizon,
                      ContactSchedule* schedule);

}  // namespace sidestep
