// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// recovery: when a robot on both feet has to step although its gait would have it stand.
//
// The instantaneous capture point tells where the CoM would come to rest were the ground to carry
// the robot there; a steady push F moves it as far as the ground must lean against that push:
//   xi = p_C + v_C / w + F / (m w^2),   w = sqrt(g / h)
// Inside the hull of the soles the feet can hold it; outside a step is the only way.
// Source: Pratt et al., "Capture point: a step toward humanoid push recovery", Humanoids 2006.

#include <Eigen/Core>
#include <vector>

#include "controller/types/robot_state.h"

namespace sidestep {

/// 1/w (s) of an inverted pendulum of this height (m), taken as 0.1 m if it is less.
double PendulumTimeConstant_s(double height_m);

/// xi of the belief (m, horizontal, in W).
Eigen::Vector2d CapturePoint(const RobotState& state, double mass_kg);

/// Distance (m) from `point` to the convex hull of the vertices of all feet, zero inside it.
/// `vertices_m` is one 3 x n_v a foot, in F.
double DistanceFromSoles(const Eigen::Vector2d& point, const std::vector<FootState>& feet,
                         const std::vector<Eigen::Matrix3Xd>& vertices_m);

}  // namespace sidestep
