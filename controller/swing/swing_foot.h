// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// swing_foot: a foot's motion through the air, re-targeted while it flies.
//
// Every tick joins the reference as it is (position, velocity, acceleration) to the foothold wanted
// now by a quintic; with an unchanged foothold that is the same curve, with a new one acceleration
// stays continuous. Height goes over an apex at half the swing (a lower one if there is no time for
// it) and arrives with a small downward speed, so that a floor a little lower than believed is
// still found. One that is late searches on downwards, faster and faster if it is told to, to a
// stated depth. One that leaves a place lower than its next one rises to that height first: what it
// stood in has a wall.

#include <Eigen/Core>

#include "controller/types/contact_plan.h"
#include "controller/types/quintic.h"
#include "controller/types/swing_limits.h"
#include "controller/types/tick.h"

namespace sidestep {

/// How a foot that is due looks for the floor below where it should be; see PlannerParams.
struct FloorSearch {
  double depth_m{0.06};
  double acceleration_mps2{0.0};  ///< Downwards, from the landing speed on.
};

class SwingFoot {
 public:
  explicit SwingFoot(double tick_s, const FloorSearch& search = {}, const SwingLimits& limits = {})
      : tick_s_(tick_s), search_(search), limits_(limits) {}

  /// Begins a swing of that shape at `tick` from where the foot is, at rest on the ground.
  void LiftOff(const SwingShape& shape, const Eigen::Vector3d& p_WF, Tick tick);

  /// Reference at `tick`, on the way to `p_WF_target` at landing_tick. Call every control tick.
  /// After landing_tick the foot goes on down from the landing speed on, to the search's depth.
  void Update(const Eigen::Vector3d& p_WF_target, Tick landing_tick, Tick tick);

  /// Reference at `tick` of a foot that stood at `p_WF` until its contact was lost at `lost_tick`:
  /// it goes down as a late one does.
  void GoDown(const Eigen::Vector3d& p_WF, Tick lost_tick, Tick tick);

  /// The reference of the last call, in W (m, m/s, m/s^2).
  Eigen::Vector3d position() const;
  Eigen::Vector3d velocity() const;
  Eigen::Vector3d acceleration() const;

 private:
  void UpdateHeight(Tick landing_tick, Tick tick);
  QuinticState HeightBelow(double height_m, Tick late) const;

  SwingShape shape_;
  double tick_s_;
  FloorSearch search_;
  SwingLimits limits_;
  Tick lift_off_tick_{0};
  Tick landing_tick_{0};   // that the highest apex is for
  double highest_m_{0.0};  // that the foot can rise to by half of that swing
  Tick tick_{0};           // of the reference below
  double lift_off_height_m_{0.0};
  Eigen::Vector3d target_p_WF_{Eigen::Vector3d::Zero()};
  QuinticState x_, y_, z_;
};

}  // namespace sidestep
