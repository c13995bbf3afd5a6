// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// contact_plan: where and when each foot is meant to stand.

#include <Eigen/Core>
#include <vector>

#include "controller/types/tick.h"

namespace sidestep {

/// Shape of the swing that leads to a contact.
struct SwingShape {
  double height_m{0.05};          ///< Apex above the higher of the two footholds.
  double landing_speed_mps{0.3};  ///< Downwards, at touch-down; where it searches, to begin with.
};

/// One stay of a foot on the ground, in absolute ticks: start <= tick < end.
struct PlannedContact {
  int index{0};             ///< Counts this foot's contacts from 0 over the whole episode.
  bool end_is_known{true};  ///< False: nothing ends it as far as the plan goes.
  Tick start_tick{0};
  /// When the foot was to land, no later than start_tick: the schedule waits for one that is not
  /// felt.
  Tick due_tick{0};
  /// If its end is not known: a tick beyond the plan. Not an std::optional, for `tick < end_tick`
  /// would compile with that, and be false.
  Tick end_tick{0};
  Eigen::Matrix3d R_WF{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d nominal_p_WF{Eigen::Vector3d::Zero()};   ///< What the gait planner wants.
  Eigen::Vector3d adjusted_p_WF{Eigen::Vector3d::Zero()};  ///< What the MPC decided last.
  Eigen::Vector3d box_lower_m{Eigen::Vector3d::Zero()};    ///< Adjustment's bounds, in F.
  Eigen::Vector3d box_upper_m{Eigen::Vector3d::Zero()};
  SwingShape swing;  ///< Of the gait whose step lands here.
};

/// Where the MPC decided that a contact shall be.
struct Foothold {
  int foot{0};
  int index{0};                                   ///< PlannedContact::index.
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};  ///< m.
};

/// The contacts of every foot that end after now and begin before the horizon's end, by time.
struct ContactPlan {
  std::vector<std::vector<PlannedContact>> feet;
  /// Contact changes to come are whole steps of the MPC's horizon away from this tick, as far as
  /// the gait's times are; it may have passed or not.
  Tick grid_tick{0};
};

/// Nominal motion of the CoM at one instant (m, m/s, m/s^2), in W.
struct ComReference {
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d a_WC{Eigen::Vector3d::Zero()};
};

}  // namespace sidestep
