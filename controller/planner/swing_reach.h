// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// swing_reach: how far a foot that is in the air, or next to leave the ground, may be sent.
//
// Feet fly on curves of least jerk (types/quintic.h): rest to rest over a distance d in a time T
// takes 10 / sqrt(3) d / T^2 of acceleration at its peak. A foot that moves already drifts by
// v T / 2 while it brakes, so with a bound on acceleration it reaches what lies about p + v T / 2.

#include <Eigen/Core>
#include <vector>

#include "controller/planner/contact_schedule.h"
#include "controller/types/swing_limits.h"

namespace sidestep {

/// A foot at one instant, in W.
struct MovingFoot {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};  ///< m.
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};  ///< m/s.
};

/// Narrows the box of every foot's next contact at `tick`, along the contact's x and y, to what the
/// foot reaches in the time that it has: left of a foot in the air, from lift-off to landing of one
/// that stands. So the nearer the landing, the less its foothold moves. Where the box holds nothing
/// of that, what remains is its place next to the foot.
void KeepWithinSwing(const std::vector<MovingFoot>& feet, const SwingLimits& limits, Tick tick,
                     double tick_s, ContactSchedule* schedule);

}  // namespace sidestep
