// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_parts.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <set>

#include "models/robot_description/force_shares.h"
#include "models/support/nearest_name.h"

namespace sidestep {
namespace {

constexpr double kMaxJointPosition = 100.0;  // rad or m
constexpr double kMaxNumber = 1e6;

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Eigen::Matrix3Xd ReadVertices(const ConfigNode& node) {
  const std::vector<ConfigNode> points = node.List();
  if (points.empty()) node.Fail("must hold at least one vertex");
  Eigen::Matrix3Xd vertices_m(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    vertices_m.col(static_cast<Eigen::Index>(i)) = points[i].Vector3(-kMaxLength_m, kMaxLength_m);
  }
  return vertices_m;
}

/// Names of force/torque sensors, each with both its sensors in the model.
std::vector<std::string> ReadForceTorque(const ConfigNode& node, const KnownParts& parts) {
  std::vector<std::string> names = ReadNames(node);
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (const char* quantity : {"_force", "_torque"}) {
      RequireSensor(node.List()[i], parts, names[i] + quantity);
    }
  }
  return names;
}

/// What a foot of a robot with a model feels the ground by.
void ReadFootSensors(ConfigMap& map, const KnownParts& parts, FootDescription* foot) {
  if (const auto sensors = map.Optional("force_torque")) {
    foot->force_torque = ReadForceTorque(*sensors, parts);
    if (foot->force_torque.empty()) sensors->Fail("must hold at least one sensor");
  } else if (parts.language == ModelLanguage::kUrdf) {
    map.Required("force_torque");
  } else {
    RequireSensor(map.Required("name"), parts, foot->name + "_touch");
  }
}

/// The shares of the vertices' forces that put the foot's centre of pressure at the node's [x, y].
Eigen::VectorXd ReadPreferredCop(const ConfigNode& node, const Eigen::Matrix3Xd& vertices_m) {
  const std::vector<double> cop_m = ReadNumbers(node, 2);
  Eigen::VectorXd shares = ForceShares(vertices_m, {cop_m[0], cop_m[1]});
  if (shares.size() == 0) {
    node.Fail("needs a negative share of the force at a vertex: it must lie nearer their mean");
  }
  return shares;
}

FootDescription ReadFoot(const ConfigNode& node, const KnownParts* parts) {
  ConfigMap map = node.Map();
  FootDescription foot;
  foot.name = map.Required("name").Word();
  if (parts != nullptr) {
    foot.frame =
        ReadPart(map.Required("frame"), parts->names.sites, parts->frame_kind, parts->language);
    ReadFootSensors(map, *parts, &foot);
  } else {
    const std::optional<ConfigNode> frame = map.Optional("frame");
    foot.frame = frame ? ReadName(*frame) : foot.name;
  }
  foot.vertices_m = ReadVertices(map.Required("vertices_m"));
  if (const auto cop = map.Optional("preferred_cop_m")) {
    foot.force_shares = ReadPreferredCop(*cop, foot.vertices_m);
  }
  if (const auto height = map.Optional("sole_height_m")) {
    foot.sole_height_m = height->Number(0.0, kMaxLength_m);
  }
  map.RejectUnknownKeys();
  return foot;
}

std::map<std::string, double> ReadHome(const ConfigNode& node, const KnownParts& parts) {
  ConfigMap map = node.Map();
  std::map<std::string, double> home;
  for (const std::string& joint : map.Keys()) {
    if (!Contains(parts.names.joints, joint)) {
      map.FailAtKey(joint, std::string("is no joint of the ") + LanguageName(parts.language) +
                               "; " + DidYouMean(joint, parts.names.joints, "known ones"));
    }
    home[joint] = map.Required(joint).Number(-kMaxJointPosition, kMaxJointPosition);
  }
  return home;
}

}  // namespace

std::string ReadName(const ConfigNode& node) {
  std::string name = node.Text();
  if (name.empty()) node.Fail("must not be empty");
  return name;
}

std::vector<std::string> ReadNames(const ConfigNode& node) {
  std::vector<std::string> names;
  for (const ConfigNode& element : node.List()) {
    names.push_back(ReadName(element));
    if (std::count(names.begin(), names.end(), names.back()) > 1) {
      element.Fail("= '" + names.back() + "' is there twice");
    }
  }
  return names;
}

std::string ReadPart(const ConfigNode& node, const std::vector<std::string>& known,
                     const std::string& kind, ModelLanguage language) {
  std::string name = ReadName(node);
  if (!Contains(known, name)) {
    node.Fail("= '" + name + "' is no " + kind + " of the " + LanguageName(language) + "; " +
              DidYouMean(name, known, "known ones"));
  }
  return name;
}

std::vector<std::string> ReadParts(const ConfigNode& node, const std::vector<std::string>& known,
                                   const std::string& kind, ModelLanguage language) {
  for (const ConfigNode& element : node.List()) ReadPart(element, known, kind, language);
  return ReadNames(node);
}

std::vector<double> ReadNumbers(const ConfigNode& node, std::size_t count) {
  std::vector<double> numbers;
  for (const ConfigNode& element : node.List()) {
    numbers.push_back(element.Number(-kMaxNumber, kMaxNumber));
  }
  if (numbers.size() != count) {
    node.Fail("must be a list of " + std::to_string(count) + " numbers, not of " +
              std::to_string(numbers.size()));
  }
  return numbers;
}

void RequireSensor(const ConfigNode& at, const KnownParts& parts, const std::string& sensor) {
  if (!Contains(parts.names.sensors, sensor)) {
    at.Fail("needs a sensor '" + sensor + "', which the " + LanguageName(parts.language) +
            " lacks");
  }
}

std::vector<FootDescription> ReadFeet(const ConfigNode& node, const KnownParts* parts) {
  std::vector<FootDescription> feet;
  std::set<std::string> seen;
  for (const ConfigNode& element : node.List()) {
    feet.push_back(ReadFoot(element, parts));
    if (!seen.insert(feet.back().name).second) {
      element.Map().Required("name").Fail("= '" + feet.back().name + "' names two feet");
    }
  }
  if (feet.empty()) node.Fail("must hold at least one foot");
  return feet;
}

void ReadModelParts(ConfigMap& map, const KnownParts& parts, RobotDescription* robot) {
  const MjcfNames& names = parts.names;
  const ConfigNode base = map.Required("base");
  if (const auto fault = names.base_faults.find(ReadName(base)); fault != names.base_faults.end()) {
    base.Fail("= '" + fault->first + "' can't be the base: " + fault->second);
  }
  robot->base = ReadPart(base, names.floating_bodies, parts.base_kind, parts.language);
  const ConfigNode imu = map.Required("imu");
  robot->imu = ReadPart(imu, names.sites, parts.frame_kind, parts.language);
  for (const char* quantity : {"_orientation", "_gyro", "_accelerometer"}) {
    RequireSensor(imu, parts, robot->imu + quantity);
  }
  if (const auto torso = map.Optional("torso")) {
    robot->torso = ReadPart(*torso, names.sites, parts.frame_kind, parts.language);
  }
  robot->base_height_m = map.Required("base_height_m").Number(0.0, kMaxLength_m);
  if (const auto rpy = map.Optional("base_rpy_rad")) {
    robot->base_rpy_rad = rpy->Vector3(-2.0 * std::numbers::pi, 2.0 * std::numbers::pi);
  }
  if (const auto home = map.Optional("home")) robot->home = ReadHome(*home, parts);
  if (const auto arms = map.Optional("arm_force_torque")) {
    robot->arm_force_torque = ReadForceTorque(*arms, parts);
  }
  robot->feet = ReadFeet(map.Required("feet"), &parts);
}

}  // namespace sidestep
