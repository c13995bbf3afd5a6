// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push_limit: the largest push that a linear pendulum with a robot's feet survives.
//
// In : LimitParams, directions, moments of a step.    Out: an impulse over mass for each of them.
// Of the walk's DCM and every manoeuvre, the largest step of velocity that leaves the DCM in a set
// that the manoeuvre captures. An upper bound for a robot that neither turns its body nor changes
// its height: it foresees the push and lands where it likes. Directions are told in the frame of a
// step: 0 ahead, pi/2 towards the foot in the air or the one that has just landed (so as a
// scenario's direction_rad where that is the left one; of the right one they are mirrored).

#include <string>
#include <vector>

#include "controller/types/gait_params.h"
#include "sim/limit/limit_params.h"

namespace sidestep::limit {

/// When a push begins.
struct PushMoment {
  std::string name;
  double time_s{0.0};  ///< Since the step's begin: lift-off of a walk, touch-down of a hop.
};

/// A pendulum to be pushed.
struct LimitTask {
  LimitParams params;
  GaitType gait{GaitType::kWalk};  ///< A walk, a stand on two feet or a hop.
  bool is_planar{false};           ///< Nothing happens sideways.
  StepFreedom freedom{StepFreedom::kFree};
  std::vector<PushMoment> moments;
  std::vector<double> directions_rad;
};

/// `count` moments of a step, evenly spread from its begin on, called by their percentage of it;
/// "standing" alone of a stand.
std::vector<PushMoment> EvenMoments(const LimitParams& params, GaitType gait, int count);

/// The moments that matter, by name. Of a walk lift_off, mid_swing, before_landing (0.05 s before
/// it) and, where there is one, double_support (its middle); of a hop touch_down, mid_stance,
/// lift_off, mid_flight.
std::vector<PushMoment> NamedMoments(const LimitParams& params, GaitType gait);

/// `count` directions (rad), evenly spread from 0 on. Of a planar robot 0 and pi alone.
std::vector<double> EvenDirections(int count, bool is_planar);

/// By moment and direction, the largest step of the CoM's velocity (m/s, which is N s/kg) that can
/// be survived; 0 if not even the gait itself can go on. No freedom makes it smaller. Of a hop the
/// times are no matter of choice, and all directions are alike.
std::vector<std::vector<double>> LargestVelocitySteps(const LimitTask& task);

/// How many times the impulse of an instant push one may have that lasts `duration_s` at a constant
/// force: x / (1 - e^-x) with x = omega duration. It holds while a robot stands on the ground, as
/// the DCM sums the past as e^(omega t), and for one that knows how long the push will last.
double HeldPushFactor(double omega_per_s, double duration_s);

}  // namespace sidestep::limit
