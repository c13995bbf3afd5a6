// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// capture_point: how far a robot has been pushed off, in the one measure that position and speed
// share.
//
// The instantaneous capture point tells where the CoM would come to rest were the ground to carry
// the robot there:  xi = p_C + v_C / w,  w = sqrt(g / h),  with h the CoM's height.
// Source: Pratt et al., "Capture point: a step toward humanoid push recovery", Humanoids 2006.

#include <Eigen/Core>

#include "controller/types/contact_plan.h"
#include "controller/types/robot_state.h"

namespace sidestep {

/// 1/w (s) of an inverted pendulum of this height (m), taken as 0.1 m if it is less.
double PendulumTimeConstant_s(double height_m);

/// Capture point of the belief less that of the nominal motion (m, in W, horizontal: z is zero),
/// both at `height_m`.
Eigen::Vector3d CapturePointError(const RobotState& state, const ComReference& nominal,
                                  double height_m);

}  // namespace sidestep
