// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_geometry.h"

#include "models/support/require.h"

namespace sidestep {

GaitGeometry MakeGaitGeometry(const RobotDescription& robot, const PlannerParams& planner,
                              const MpcParams& mpc) {
  SIDESTEP_REQUIRE(!robot.feet.empty(), robot.name);
  GaitGeometry geometry;
  geometry.num_feet = static_cast<int>(robot.feet.size());
  geometry.com_height_m = robot.com_height_m;
  geometry.sole_height_m = robot.feet.front().sole_height_m;
  geometry.box_lower_m = mpc.box_lower_m;
  geometry.box_upper_m = mpc.box_upper_m;
  geometry.com_sway = planner.com_sway;
  return geometry;
}

}  // namespace sidestep
