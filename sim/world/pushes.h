// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// pushes: scripted forces as they act at a tick, in W.
//
// In : the scenario's pushes; where the pushed bodies are now.     Out: force and point in W.
// A tick feels a push by the share of it that the push takes, so that impulses are exact whenever a
// push begins and however short it is.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "controller/types/tick.h"
#include "sim/scenario/push.h"
#include "sim/world/world.h"

namespace sidestep {

/// Where a pushed body or frame is: its origin O (m) and axes.
struct PushedPose {
  Eigen::Vector3d p_WO{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R_WO{Eigen::Matrix3d::Identity()};
};

/// Share of force_N that acts during `tick`: the mean over the tick of what the push's profile has
/// it be, which is 0 outside the push; exactly 1 on a tick that a constant push fills.
double PushShare(const Push& push, Tick tick, double tick_s);

/// Yaw of B: angle about z from W's x to the horizontal part of B's x (rad).
double HeadingRad(const Eigen::Quaterniond& q_WB);

/// The scenario's pushes. Remembers the heading at each push's start.
class Pushes {
 public:
  /// @param tick_s  Length of a tick (s), > 0.
  Pushes(std::vector<Push> pushes, double tick_s);

  const std::vector<Push>& pushes() const { return pushes_; }

  /// Every push at `tick`; ticks must not go back. A push that does not act has zero force.
  /// @param poses        Of the pushed bodies now, one a push.
  /// @param heading_rad  The base's yaw now.
  const std::vector<PushTruth>& Update(Tick tick, std::span<const PushedPose> poses,
                                       double heading_rad);

 private:
  struct Latch {
    bool has_started{false};  ///< The heading is taken once.
    double heading_rad{0.0};  ///< Of the base on the push's first tick.
  };

  std::vector<Push> pushes_;
  double tick_s_;
  std::vector<Latch> latches_;
  std::vector<PushTruth> acting_;  ///< One a push, what Update() returns.
};

}  // namespace sidestep
