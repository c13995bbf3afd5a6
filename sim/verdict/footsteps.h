// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// footsteps: the nominal contacts of a run beside the touch-downs that the truth made of them.
//
// Touch-downs and nominal contacts of a foot are paired by time: a touch-down belongs to the
// contact whose start is nearest; of several that belong to one contact, the nearest has it. So an
// extra step takes no other step's contact, a missing one leaves its contact without a place, and
// a schedule that is late by less than half a stride keeps its pairs. One that is later goes on
// with the next contact: its steps are told beside contacts one stride on, the first contact that
// it skipped has no place, and the step for which no contact is left is told as an extra one. What
// the controller planned is paired in the same way.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "controller/types/tick.h"
#include "sim/scenario/nominal_motion.h"
#include "sim/verdict/plan_log.h"
#include "sim/verdict/step_log.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

/// For every one of `slots` (ticks, ascending) the number of the one of `events` (likewise) that
/// has it, by the rule above; of two as near, the earlier.
std::vector<std::optional<std::size_t>> PairByTime(std::span<const Tick> slots,
                                                   std::span<const Tick> events);

/// A record for every nominal contact that began by `last_tick` or was met by a touch-down, and one
/// with contact index -1 for every step that the gait does not have; in order of start, those of
/// one instant in the order of feet. A contact is that of the gait, with the place, box and yaw
/// that the controller planned for it if it told (the box is bounds of adjusted - nominal still).
/// What it planned more than 0.3 s away from an extra step is not that step's.
std::vector<FootstepRecord> MakeFootsteps(const NominalMotion& nominal, const StepLog& steps,
                                          const PlanLog& plan, Tick last_tick);

}  // namespace sidestep
