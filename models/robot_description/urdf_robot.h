// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdf_robot: what robot.yaml adds to a URDF: motors, servos, force/torque sensors, self-collision.

#include "models/robot_description/robot_description.h"
#include "models/support/config_node.h"

namespace sidestep {

/// Reads `urdf` and all keys of a robot that has one, converts it and has MuJoCo compile it.
/// Fills robot->model, joints, force_torque and what ReadModelParts reads.
/// Throws ConfigError at the value's place, or naming the URDF for what is wrong in there.
void ReadUrdfRobot(ConfigMap& map, RobotDescription* robot);

}  // namespace sidestep
