// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// swing_reach: how far a foot that is in the air may still be sent.

#include <Eigen/Core>
#include <vector>

#include "controller/planner/contact_schedule.h"

namespace sidestep {

/// Narrows the box of every contact that a foot in the air flies to at `tick`, along the contact's
/// x and y, to what the foot reaches at `speed_mps` (a mean; > 0) in the time that it has left. So
/// the nearer the landing, the less its foothold moves. Where the box holds nothing of that, what
/// remains is its place next to the foot. `p_WF` (m): where the feet are.
void KeepWithinSwing(const std::vector<Eigen::Vector3d>& p_WF, double speed_mps, Tick tick,
                     double tick_s, ContactSchedule* schedule);

}  // namespace sidestep
