// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_geometry.h"

#include "models/support/require.h"

namespace sidestep {

GaitGeometry MakeGaitGeometry(const RobotDescription& robot, const ComSway& sway) {
  SIDESTEP_REQUIRE(!robot.feet.empty(), robot.name);
  GaitGeometry geometry;
  geometry.num_feet = static_cast<int>(robot.feet.size());
  geometry.com_height_m = robot.com_height_m;
  geometry.sole_height_m = robot.feet.front().sole_height_m;
  geometry.sway = sway;
  return geometry;
}

}  // namespace sidestep
