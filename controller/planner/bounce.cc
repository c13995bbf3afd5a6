// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/bounce.h"

#include <numbers>

#include "models/support/gravity.h"

namespace sidestep {

Bounce BounceOf(const GaitParams& gait) {
  const double lift_off_mps = 0.5 * kGravity_mps2 * gait.flight_s;
  Bounce bounce;
  bounce.rise_m = 0.25 * lift_off_mps * gait.flight_s;
  bounce.depth_m = lift_off_mps * gait.stance_s / std::numbers::pi;
  bounce.stance_mps2 = std::numbers::pi * lift_off_mps / gait.stance_s;
  return bounce;
}

}  // namespace sidestep
