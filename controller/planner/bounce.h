// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// bounce: how the CoM of a robot that runs or hops goes up and down.
//
// In flight it falls freely; on the ground the force above the weight is half a wave of a sine.
// With flights of T_f between stances of T_s, both as high at touch-down as at lift-off:
//   v     = g T_f / 2            upwards at lift-off, downwards at touch-down
//   rise  = g T_f^2 / 8          of the apex
//   depth = v T_s / pi           of the middle of the stance
//   a     = pi v / T_s           upwards there
// from a(t) = a sin(pi t / T_s) over a stance, which turns -v to v.
// The reference joins the middles of stance and flight by quintics: by 5 % of rise and depth and a
// quarter of g it is not quite that.
// Source: a spring-mass runner of small displacements, as in Blickhan, "The spring-mass model for
// running and hopping", Journal of Biomechanics 22 (1989).

#include "controller/types/gait_params.h"

namespace sidestep {

/// All relative to touch-down and lift-off.
struct Bounce {
  double rise_m{0.0};
  double depth_m{0.0};
  double stance_mps2{0.0};  ///< In the middle of the stance, upwards.
};

/// Of a run or hop of these times; zeros without flight.
Bounce BounceOf(const GaitParams& gait);

}  // namespace sidestep
