// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// step_width: keeps the feet from landing on each other when steps are adjusted.

#include "controller/planner/contact_schedule.h"
#include "controller/types/tick.h"

namespace sidestep {

/// Ends the box of each foot's next landing after `tick` where its foot would come nearer to the
/// one that stands then than `min_width_m` (m, along y of the contact frame). A box out of reach
/// shrinks to its nearest line; never is it inside out. Of one foot nothing changes.
void KeepFeetApart(double min_width_m, Tick tick, ContactSchedule* schedule);

}  // namespace sidestep
