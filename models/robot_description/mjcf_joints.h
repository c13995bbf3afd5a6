// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_joints: the servos that robot.yaml gives the motors of an MJCF.

#include "models/robot_description/robot_description.h"
#include "models/robot_description/robot_parts.h"
#include "models/support/config_node.h"

namespace sidestep {

/// Reads `joints`, groups of joints with the same servo, each of a motor. Fills robot->joints in
/// the order of the MJCF's actuators. What the MJCF tells itself (torque limits, armature, damping)
/// is refused. Throws ConfigError at the value's place; also if a motor is left without a servo.
void ReadMjcfJoints(const ConfigNode& groups, const KnownParts& parts, RobotDescription* robot);

}  // namespace sidestep
