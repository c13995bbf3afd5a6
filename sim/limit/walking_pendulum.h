// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// walking_pendulum: the walk or stand that a push meets, in closed form.

#include <Eigen/Core>

#include "sim/limit/limit_params.h"

namespace sidestep::limit {

/// The pendulum at one moment, in the frame of a step (see step_axis.h): from a foot's lift-off to
/// the next foot's, about the foot that stands throughout. On both feet the other one has just
/// landed.
struct PendulumState {
  Eigen::Vector2d dcm_m{0.0, 0.0};         ///< xi = p + v / omega of the CoM.
  Eigen::Vector2d other_foot_m{0.0, 0.0};  ///< In the air or on the ground.
  bool is_in_swing{false};
  double left_s{0.0};   ///< Of the swing, or of the time on both feet.
  double since_s{0.0};  ///< Since the landing, on both feet; longer than any of a stand.
};

/// The DCM at lift-off about the standing foot's centre of pressure, of a walk that repeats itself.
/// The centre of pressure stays put in the swing and goes over at an even speed on both feet.
Eigen::Vector2d LiftOffOffset(const LimitParams& params);

/// The walk `time_s` (0 <= time_s < swing_s + double_support_s) after a foot has left the ground;
/// that foot flies on a curve of least jerk.
PendulumState WalkAt(const LimitParams& params, double time_s);

/// At rest in the middle between both feet, at no step ahead.
PendulumState StandOf(const LimitParams& params);

}  // namespace sidestep::limit
