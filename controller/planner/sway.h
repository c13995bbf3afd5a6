// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sway: how the CoM of a walk goes from side to side.
//
// A linear pendulum over feet at -d and d, whose CoP stays in each for S and moves evenly from one
// to the other in D, has one motion that repeats. With w^2 = g / h and T = S + D, in mid-swing it
// is A = d (1 - [sinh(wD/2) / (wD/2)] / cosh(wT/2)) to the side and turns back with w^2 (d - A); in
// mid-support it crosses the path at 2d/D (1 - cosh(wS/2) / cosh(wT/2)). Along such a reference the
// capture point of an unpushed walk is where it should be.

#include "controller/types/gait_params.h"

namespace sidestep {

struct Sway {
  double share{0.0};             ///< Of the way from the path to the standing foot, in mid-swing.
  double haste{1.0};             ///< Crossing the path: speed over the mean from side to side.
  double turn_back_per_s2{0.0};  ///< Acceleration in mid-swing per metre from the path to the foot.
};

/// Of a walk of these times by a robot whose CoM is `height_m` above the ground. A slow walk's
/// pendulum stands over one foot, then over the other; a robot that is asked for less sways less.
Sway SwayOf(const ComSway& asked, const GaitParams& gait, double height_m);

}  // namespace sidestep
