// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_servo: the keys that a group of joints has whatever language its model is in.

#include "models/robot_description/robot_description.h"
#include "models/support/config_node.h"

namespace sidestep {

// Bounds that only catch slips of the pen.
inline constexpr double kMaxServoGain = 1e6;   ///< Nm/rad and Nms/rad.
inline constexpr double kMaxMotorLimit = 1e5;  ///< Nm and rad/s.
inline constexpr double kMaxPostureWeight = 1e6;

/// Reads servo_stiffness_Nm_per_rad, servo_damping_Nms_per_rad and posture_weight into `joint`.
/// Throws ConfigError with file:line:column.
inline void ReadServo(ConfigMap& map, JointDescription* joint) {
  joint->servo_stiffness_Nm_per_rad =
      map.Required("servo_stiffness_Nm_per_rad").Number(0.0, kMaxServoGain);
  joint->servo_damping_Nms_per_rad =
      map.Required("servo_damping_Nms_per_rad").Number(0.0, kMaxServoGain);
  if (const auto weight = map.Optional("posture_weight")) {
    joint->posture_weight = weight->Number(0.0, kMaxPostureWeight);
  }
}

}  // namespace sidestep
