// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_setup: what a gait is generated from and what does not change as it goes on.

#include <Eigen/Core>
#include <vector>

#include "controller/types/gait_params.h"
#include "controller/types/tick.h"

namespace sidestep {

/// What the gait must know of the robot.
struct GaitGeometry {
  int num_feet{1};            ///< 1 or 2; foot 0 of two is the left one (+y).
  double com_height_m{0.5};   ///< Above the ground.
  double sole_height_m{0.0};  ///< Height of F in stance.
  /// Bounds of a step's adjustment in the contact frame (m), of a single or left foot; the right
  /// foot's are mirrored in y.
  Eigen::Vector3d box_lower_m{Eigen::Vector3d::Zero()};
  Eigen::Vector3d box_upper_m{Eigen::Vector3d::Zero()};
  ComSway sway;  ///< PlannerParams::sway.
};

struct GaitSetup {
  std::vector<GaitParams> segments;  ///< At least one; in order of start_s, the first at 0.
  GaitGeometry geometry;
  double tick_s{0.001};  ///< One tick.
};

/// Shortest time (s) from one touch-down to the next: the lower end of GaitParams::stance_s. Bounds
/// how many steps a horizon holds, and with that the memory of a schedule.
inline constexpr double kShortestStep_s = 0.02;

}  // namespace sidestep
