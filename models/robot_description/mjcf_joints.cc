// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/mjcf_joints.h"

#include <algorithm>
#include <map>

#include "models/robot_description/read_servo.h"

namespace sidestep {
namespace {

/// What all joints of a group have.
JointDescription ReadGroup(ConfigMap& map) {
  JointDescription servo;
  const ConfigNode speed = map.Required("velocity_limit_radps");
  servo.velocity_limit_radps = speed.Number(0.0, kMaxMotorLimit);
  if (servo.velocity_limit_radps <= 0.0) speed.Fail("must be greater than 0");
  ReadServo(map, &servo);
  for (const char* key : {"torque_limit_Nm", "armature_kgm2", "damping_Nms_per_rad"}) {
    if (map.Optional(key)) map.FailAtKey(key, "is told by the MJCF; leave it out");
  }
  return servo;
}

}  // namespace

void ReadMjcfJoints(const ConfigNode& groups, const KnownParts& parts, RobotDescription* robot) {
  const std::vector<std::string>& motors = parts.names.motor_joints;
  std::map<std::string, JointDescription> servos;
  for (const ConfigNode& group : groups.List()) {
    ConfigMap map = group.Map();
    const ConfigNode names = map.Required("names");
    const std::vector<std::string> joints =
        ReadParts(names, motors, "joint with a motor", parts.language);
    if (joints.empty()) names.Fail("must hold at least one joint");
    JointDescription servo = ReadGroup(map);
    map.RejectUnknownKeys();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      servo.name = joints[i];
      if (servos.insert_or_assign(joints[i], servo).second) continue;
      names.List()[i].Fail("= '" + joints[i] + "' is in two groups");
    }
  }
  std::string missing;
  for (const std::string& motor : motors) {
    const auto servo = servos.find(motor);
    if (servo != servos.end()) {
      robot->joints.push_back(servo->second);
    } else {
      missing += (missing.empty() ? "'" : ", '") + motor + "'";
    }
  }
  if (!missing.empty()) groups.Fail("must name every joint with a motor, also " + missing);
}

}  // namespace sidestep
