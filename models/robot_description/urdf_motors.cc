// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/urdf_motors.h"

#include <algorithm>

#include "models/robot_description/read_servo.h"
#include "models/robot_description/robot_parts.h"

namespace sidestep {
namespace {

constexpr double kMaxArmature_kgm2 = 1e2;
constexpr const char* kRest = "rest";

/// The value of `key`, or what the URDF says of the joint, which must not be nothing then.
double ReadLimit(ConfigMap& map, const std::string& key, double of_urdf, const std::string& joint) {
  const auto node = map.Optional(key);
  const double limit = node ? node->Number(0.0, kMaxMotorLimit) : of_urdf;
  const bool is_good = limit > 0.0;
  if (!is_good && node) node->Fail("must be greater than 0");
  if (!is_good) map.Fail("needs " + key + ", because the URDF has none for '" + joint + "'");
  return limit;
}

/// One group of `joints`: the same numbers for all its names.
class JointGroupReader {
 public:
  JointGroupReader(const UrdfParts& urdf, RobotDescription* robot, UrdfConversion* conversion)
      : urdf_(urdf), robot_(robot), conversion_(conversion) {}

  void Read(const ConfigNode& node) {
    ConfigMap map = node.Map();
    const ConfigNode names = map.Required("names");
    const std::vector<std::string> moving = NamesOfJoints(urdf_, conversion_->locked_joints);
    const std::vector<std::string> joints =
        ReadParts(names, moving, "moving joint", ModelLanguage::kUrdf);
    if (joints.empty()) names.Fail("must hold at least one joint");
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const bool is_known =
          std::any_of(robot_->joints.begin(), robot_->joints.end(),
                      [&](const JointDescription& joint) { return joint.name == joints[i]; });
      if (is_known) names.List()[i].Fail("= '" + joints[i] + "' is in two groups");
      Add(joints[i], map);
    }
    map.RejectUnknownKeys();
  }

 private:
  void Add(const std::string& name, ConfigMap& map) {
    const UrdfJointInfo& info =
        *std::find_if(urdf_.joints.begin(), urdf_.joints.end(),
                      [&](const UrdfJointInfo& joint) { return joint.name == name; });
    UrdfActuator actuator{name};
    actuator.torque_limit_Nm = ReadLimit(map, "torque_limit_Nm", info.effort_Nm, name);
    actuator.damping_Nms_per_rad = info.damping_Nms_per_rad;
    if (const auto armature = map.Optional("armature_kgm2")) {
      actuator.armature_kgm2 = armature->Number(0.0, kMaxArmature_kgm2);
    }
    if (const auto damping = map.Optional("damping_Nms_per_rad")) {
      actuator.damping_Nms_per_rad = damping->Number(0.0, kMaxServoGain);
    }
    conversion_->actuators.push_back(actuator);

    JointDescription joint;
    joint.name = name;
    joint.velocity_limit_radps = ReadLimit(map, "velocity_limit_radps", info.velocity_radps, name);
    ReadServo(map, &joint);
    robot_->joints.push_back(joint);
  }

  const UrdfParts& urdf_;
  RobotDescription* robot_;
  UrdfConversion* conversion_;
};

/// Joints that are locked by name, or nothing where the rest is: that is known after the groups.
std::vector<std::string> ReadLocked(ConfigMap& map, const UrdfParts& urdf, bool* is_rest) {
  const auto rest = map.Optional("locked");
  const auto names = map.Optional("locked_joints");
  *is_rest = rest.has_value();
  if (rest && rest->Text() != kRest) {
    rest->Fail("= '" + rest->Text() + "' must be rest: every joint that no group of joints names");
  }
  if (rest && names) map.FailAtKey("locked_joints", "can't be beside locked: rest");
  if (!names) return {};
  return ReadParts(*names, NamesOfJoints(urdf, {}), "moving joint", ModelLanguage::kUrdf);
}

std::vector<std::string> NamesOfMotors(const RobotDescription& robot) {
  std::vector<std::string> names;
  for (const JointDescription& joint : robot.joints) names.push_back(joint.name);
  return names;
}

}  // namespace

std::vector<std::string> NamesOfJoints(const UrdfParts& urdf,
                                       const std::vector<std::string>& without) {
  std::vector<std::string> names;
  for (const UrdfJointInfo& joint : urdf.joints) {
    const bool is_out = std::find(without.begin(), without.end(), joint.name) != without.end();
    if (!is_out) names.push_back(joint.name);
  }
  return names;
}

void ReadJoints(ConfigMap& map, const UrdfParts& urdf, RobotDescription* robot,
                UrdfConversion* conversion) {
  bool is_rest_locked = false;
  conversion->locked_joints = ReadLocked(map, urdf, &is_rest_locked);
  const ConfigNode groups = map.Required("joints");
  JointGroupReader reader(urdf, robot, conversion);
  for (const ConfigNode& group : groups.List()) reader.Read(group);
  if (is_rest_locked) conversion->locked_joints = NamesOfJoints(urdf, NamesOfMotors(*robot));
}

void RequireMotors(ConfigMap& map, const UrdfParts& urdf, const RobotDescription& robot,
                   const UrdfConversion& conversion) {
  std::vector<std::string> others = NamesOfMotors(robot);
  others.insert(others.end(), conversion.locked_joints.begin(), conversion.locked_joints.end());
  std::string missing;
  for (const std::string& name : NamesOfJoints(urdf, others)) {
    missing += (missing.empty() ? "'" : ", '") + name + "'";
  }
  if (missing.empty()) return;
  map.Required("joints").Fail("must name " + missing + ", or locked_joints must (or locked: rest)");
}

}  // namespace sidestep
