// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_description.h"

#include <algorithm>
#include <optional>
#include <set>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/mjcf_names.h"
#include "models/support/config_node.h"
#include "models/support/nearest_name.h"

namespace sidestep {
namespace {

constexpr int kFormatVersion = 1;
constexpr double kMaxLength_m = 10.0;  // No legged robot is larger; catches millimetres.
constexpr double kMaxMass_kg = 1e4;

void ReadVersion(ConfigMap& map) {
  const ConfigNode version = map.Required("sidestep_robot");
  if (version.Integer(0, 1000000) != kFormatVersion) {
    version.Fail("= " + version.Text() + " is a version that this program can't read; it reads 1");
  }
}

std::string ReadName(const ConfigNode& node) {
  std::string name = node.Text();
  if (name.empty()) node.Fail("must not be empty");
  return name;
}

/// Reads a name that must be among `known` parts of the MJCF.
std::string ReadPart(const ConfigNode& node, const std::vector<std::string>& known,
                     const std::string& kind) {
  std::string name = ReadName(node);
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    node.Fail("= '" + name + "' is no " + kind + " of the MJCF; " +
              DidYouMean(name, known, "known ones"));
  }
  return name;
}

void RequireSensor(const ConfigNode& at, const MjcfNames& names, const std::string& sensor) {
  const bool is_there =
      std::find(names.sensors.begin(), names.sensors.end(), sensor) != names.sensors.end();
  if (!is_there) at.Fail("needs a sensor '" + sensor + "', which the MJCF lacks");
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

/// `names` is null for a robot without an MJCF, whose feet are points of the centroidal plant.
FootDescription ReadFoot(const ConfigNode& node, const MjcfNames* names) {
  ConfigMap map = node.Map();
  FootDescription foot;
  foot.name = ReadName(map.Required("name"));
  if (names != nullptr) {
    foot.frame = ReadPart(map.Required("frame"), names->sites, "site");
    RequireSensor(map.Required("name"), *names, foot.name + "_touch");
  } else {
    const std::optional<ConfigNode> frame = map.Optional("frame");
    foot.frame = frame ? ReadName(*frame) : foot.name;
  }
  foot.vertices_m = ReadVertices(map.Required("vertices_m"));
  if (const auto height = map.Optional("sole_height_m")) {
    foot.sole_height_m = height->Number(0.0, kMaxLength_m);
  }
  map.RejectUnknownKeys();
  return foot;
}

std::vector<FootDescription> ReadFeet(const ConfigNode& node, const MjcfNames* names) {
  std::vector<FootDescription> feet;
  std::set<std::string> seen;
  for (const ConfigNode& element : node.List()) {
    feet.push_back(ReadFoot(element, names));
    if (!seen.insert(feet.back().name).second) {
      element.Map().Required("name").Fail("= '" + feet.back().name + "' names two feet");
    }
  }
  if (feet.empty()) node.Fail("must hold at least one foot");
  return feet;
}

std::map<std::string, double> ReadHome(const ConfigNode& node, const MjcfNames& names) {
  ConfigMap map = node.Map();
  std::map<std::string, double> home;
  for (const std::string& joint : map.Keys()) {
    if (std::find(names.joints.begin(), names.joints.end(), joint) == names.joints.end()) {
      map.FailAtKey(joint,
                    "is no joint of the MJCF; " + DidYouMean(joint, names.joints, "known ones"));
    }
    home[joint] = map.Required(joint).Number(-100.0, 100.0);
  }
  return home;
}

/// The keys of a robot that has an MJCF.
void ReadMjcfRobot(ConfigMap& map, RobotDescription* robot) {
  const ConfigNode mjcf = map.Required("mjcf");
  robot->mjcf = (robot->file.parent_path() / ReadName(mjcf)).lexically_normal();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(robot->mjcf, ignored)) {
    mjcf.Fail("= '" + mjcf.Text() + "' is no file beside this one");
  }
  if (const auto mass = map.Optional("mass_kg")) {
    mass->Fail("is told by the MJCF; leave it out");
  }
  const MjcfNames names = ReadMjcfNames(robot->mjcf);
  const ConfigNode base = map.Required("base");
  robot->base = ReadPart(base, names.free_bodies, "body with a free joint");
  const ConfigNode imu = map.Required("imu");
  robot->imu = ReadPart(imu, names.sites, "site");
  for (const char* quantity : {"_orientation", "_gyro", "_accelerometer"}) {
    RequireSensor(imu, names, robot->imu + quantity);
  }
  robot->base_height_m = map.Required("base_height_m").Number(0.0, kMaxLength_m);
  if (const auto home = map.Optional("home")) robot->home = ReadHome(*home, names);
  robot->feet = ReadFeet(map.Required("feet"), &names);
}

/// The keys of a robot of the centroidal plant: a point mass, so base, imu and joints mean nothing.
void ReadCentroidalRobot(ConfigMap& map, RobotDescription* robot) {
  const ConfigNode mass = map.Required("mass_kg");
  robot->mass_kg = mass.Number(0.0, kMaxMass_kg);
  if (robot->mass_kg <= 0.0) mass.Fail("must be greater than 0");
  robot->feet = ReadFeet(map.Required("feet"), nullptr);
  for (const char* key : {"base", "imu", "home", "base_height_m"}) {
    if (map.Optional(key)) map.FailAtKey(key, "means nothing for a robot without an mjcf");
  }
}

}  // namespace

RobotDescription ReadRobotDescription(const std::filesystem::path& file) {
  const ConfigTree tree = ReadConfigFile(file);
  ConfigMap map(tree, "");
  RobotDescription robot;
  robot.file = std::filesystem::absolute(file).lexically_normal();
  ReadVersion(map);
  robot.name = ReadName(map.Required("name"));
  robot.com_height_m = map.Required("com_height_m").Number(0.01, kMaxLength_m);
  if (map.Optional("mjcf")) {
    ReadMjcfRobot(map, &robot);
  } else {
    ReadCentroidalRobot(map, &robot);
  }
  map.Optional("control");  // gains of this robot: ReadScenario reads them
  map.RejectUnknownKeys();
  return robot;
}

std::string MjcfOf(const RobotDescription& robot) { return ReadTextFile(robot.mjcf); }

RobotNames NamesIn(const RobotDescription& description) {
  RobotNames names;
  if (!description.mjcf.empty()) {
    MjcfNames parts = ReadMjcfNames(description.mjcf);
    return {std::move(parts.bodies), std::move(parts.sites)};
  }
  names.bodies.emplace_back("com");
  for (const FootDescription& foot : description.feet) names.frames.push_back(foot.frame);
  return names;
}

}  // namespace sidestep
