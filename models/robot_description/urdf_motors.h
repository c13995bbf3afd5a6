// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdf_motors: which joints of a URDF robot.yaml moves, and by what; which it locks.

#include <string>
#include <vector>

#include "models/robot_description/robot_description.h"
#include "models/support/config_node.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

namespace sidestep {

/// Names of the joints that move, but those in `without`.
std::vector<std::string> NamesOfJoints(const UrdfParts& urdf,
                                       const std::vector<std::string>& without);

/// Reads `joints`, and `locked_joints` or `locked: rest` (every joint that no group of `joints`
/// names). Fills robot->joints and the conversion's actuators and locked joints. Throws ConfigError
/// at the value's place.
void ReadJoints(ConfigMap& map, const UrdfParts& urdf, RobotDescription* robot,
                UrdfConversion* conversion);

/// Throws ConfigError naming every joint that moves without a motor.
void RequireMotors(ConfigMap& map, const UrdfParts& urdf, const RobotDescription& robot,
                   const UrdfConversion& conversion);

}  // namespace sidestep
