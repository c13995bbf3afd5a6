// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/urdf_robot.h"

#include <algorithm>
#include <utility>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_parts.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

namespace sidestep {
namespace {

constexpr double kMaxGain = 1e6;   // Nm/rad and Nms/rad
constexpr double kMaxLimit = 1e5;  // Nm and rad/s
constexpr double kMaxArmature_kgm2 = 1e2;
constexpr double kMaxWeight = 1e6;
constexpr ModelLanguage kUrdf = ModelLanguage::kUrdf;
constexpr char kFrame[] = "link without mass";

std::vector<std::string> NamesOfJoints(const UrdfParts& urdf,
                                       const std::vector<std::string>& without) {
  std::vector<std::string> names;
  for (const UrdfJointInfo& joint : urdf.joints) {
    const bool is_out = std::find(without.begin(), without.end(), joint.name) != without.end();
    if (!is_out) names.push_back(joint.name);
  }
  return names;
}

/// The value of `key`, or what the URDF says of the joint, which must not be nothing then.
double ReadLimit(ConfigMap& map, const std::string& key, double of_urdf, const std::string& joint) {
  const auto node = map.Optional(key);
  const double limit = node ? node->Number(0.0, kMaxLimit) : of_urdf;
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
    const std::vector<std::string> joints = ReadParts(names, moving, "moving joint", kUrdf);
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
      actuator.damping_Nms_per_rad = damping->Number(0.0, kMaxGain);
    }
    conversion_->actuators.push_back(actuator);

    JointDescription joint;
    joint.name = name;
    joint.velocity_limit_radps = ReadLimit(map, "velocity_limit_radps", info.velocity_radps, name);
    joint.servo_stiffness_Nm_per_rad =
        map.Required("servo_stiffness_Nm_per_rad").Number(0.0, kMaxGain);
    joint.servo_damping_Nms_per_rad =
        map.Required("servo_damping_Nms_per_rad").Number(0.0, kMaxGain);
    if (const auto weight = map.Optional("posture_weight")) {
      joint.posture_weight = weight->Number(0.0, kMaxWeight);
    }
    robot_->joints.push_back(joint);
  }

  const UrdfParts& urdf_;
  RobotDescription* robot_;
  UrdfConversion* conversion_;
};

void ReadJoints(ConfigMap& map, const UrdfParts& urdf, RobotDescription* robot,
                UrdfConversion* conversion) {
  if (const auto locked = map.Optional("locked_joints")) {
    conversion->locked_joints = ReadParts(*locked, NamesOfJoints(urdf, {}), "moving joint", kUrdf);
  }
  const ConfigNode groups = map.Required("joints");
  JointGroupReader reader(urdf, robot, conversion);
  for (const ConfigNode& group : groups.List()) reader.Read(group);
  for (const std::string& name : NamesOfJoints(urdf, conversion->locked_joints)) {
    const bool has_motor =
        std::any_of(robot->joints.begin(), robot->joints.end(),
                    [&](const JointDescription& joint) { return joint.name == name; });
    if (!has_motor) groups.Fail("must name '" + name + "', or locked_joints must");
  }
}

/// `link` loses the mass of the part, so that the next sensor inside it finds what is left.
UrdfDistalPart ReadDistalPart(const ConfigNode& node, UrdfLinkInfo& link) {
  ConfigMap map = node.Map();
  UrdfDistalPart part;
  const ConfigNode mass = map.Required("mass_kg");
  part.mass.mass_kg = mass.Number(0.0, kMaxMass_kg);
  if (part.mass.mass_kg <= 0.0) mass.Fail("must be greater than 0");
  if (part.mass.mass_kg >= link.mass.mass_kg) {
    mass.Fail("must be less than the " + NumberText(link.mass.mass_kg) + " kg of link '" +
              link.name + "'");
  }
  part.mass.com_m = map.Required("com_m").Vector3(-kMaxLength_m, kMaxLength_m);
  const ConfigNode inertia_node = map.Required("inertia_kgm2");
  const std::vector<double> inertia = ReadNumbers(inertia_node, 6);
  part.mass.inertia_kgm2 << inertia[0], inertia[1], inertia[2], inertia[1], inertia[3], inertia[4],
      inertia[2], inertia[4], inertia[5];
  if (!IsPhysical(part.mass)) inertia_node.Fail("is an inertia that no body has");
  link.mass = Without(link.mass, part.mass);
  if (!IsPhysical(link.mass)) {
    inertia_node.Fail("leaves link '" + link.name + "' an inertia that no body has");
  }
  if (const auto joints = map.Optional("joints")) {
    part.joints = ReadParts(*joints, link.joints, "joint of link '" + link.name + "'", kUrdf);
  }
  if (const auto shapes = map.Optional("shapes")) {
    part.shapes = ReadParts(*shapes, link.shapes, "shape of link '" + link.name + "'", kUrdf);
  }
  map.RejectUnknownKeys();
  return part;
}

UrdfForceTorque ReadSensor(const ConfigNode& node, UrdfParts& urdf,
                           const std::vector<std::string>& frames) {
  ConfigMap map = node.Map();
  UrdfForceTorque sensor;
  sensor.name = ReadPart(map.Required("name"), frames, kFrame, kUrdf);
  const auto frame =
      std::find_if(urdf.frames.begin(), urdf.frames.end(),
                   [&](const UrdfFrameInfo& other) { return other.name == sensor.name; });
  const auto link =
      std::find_if(urdf.links.begin(), urdf.links.end(),
                   [&](const UrdfLinkInfo& other) { return other.name == frame->link; });
  if (const auto distal = map.Optional("distal")) {
    sensor.distal = ReadDistalPart(*distal, *link);
  } else if (link == urdf.links.begin()) {
    map.Fail("needs distal: its frame is on the base, which has no parent");
  }
  map.RejectUnknownKeys();
  return sensor;
}

void ReadSensors(const ConfigNode& node, UrdfParts urdf, const std::vector<std::string>& frames,
                 UrdfConversion* conversion) {
  for (const ConfigNode& element : node.List()) {
    conversion->force_torque.push_back(ReadSensor(element, urdf, frames));
    const std::string& name = conversion->force_torque.back().name;
    const auto count =
        std::count_if(conversion->force_torque.begin(), conversion->force_torque.end(),
                      [&](const UrdfForceTorque& sensor) { return sensor.name == name; });
    if (count > 1) element.Map().Required("name").Fail("= '" + name + "' names two sensors");
  }
}

void ReadSelfCollision(const ConfigNode& node, const std::vector<std::string>& links,
                       UrdfConversion* conversion) {
  for (const ConfigNode& element : node.List()) {
    const std::vector<ConfigNode> sides = element.List();
    if (sides.size() != 2) element.Fail("must be two lists of links");
    conversion->self_collision.push_back(
        {ReadParts(sides[0], links, "link", kUrdf), ReadParts(sides[1], links, "link", kUrdf)});
  }
}

/// What the converted model will call its parts.
KnownParts PartsAfterConversion(const UrdfParts& urdf, const UrdfConversion& conversion,
                                const std::string& imu) {
  KnownParts parts{kUrdf, {}, "base (first link with mass)", kFrame};
  for (const UrdfLinkInfo& link : urdf.links) parts.names.bodies.push_back(link.name);
  parts.names.floating_bodies = {urdf.links.front().name};
  for (const UrdfFrameInfo& frame : urdf.frames) parts.names.sites.push_back(frame.name);
  parts.names.joints = NamesOfJoints(urdf, conversion.locked_joints);
  for (const char* quantity : {"_orientation", "_gyro", "_accelerometer"}) {
    parts.names.sensors.push_back(imu + quantity);
  }
  for (const UrdfForceTorque& sensor : conversion.force_torque) {
    for (const char* quantity : {"_force", "_torque"}) {
      parts.names.sensors.push_back(sensor.name + quantity);
    }
  }
  return parts;
}

}  // namespace

void ReadUrdfRobot(ConfigMap& map, RobotDescription* robot) {
  const ConfigNode node = map.Required("urdf");
  const std::filesystem::path urdf_file =
      (robot->file.parent_path() / ReadName(node)).lexically_normal();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(urdf_file, ignored)) {
    node.Fail("= '" + node.Text() + "' is no file beside this one");
  }
  if (const auto mass = map.Optional("mass_kg")) mass->Fail("is told by the URDF; leave it out");
  const UrdfParts urdf = ReadUrdfParts(urdf_file);
  UrdfConversion conversion;
  ReadJoints(map, urdf, robot, &conversion);
  conversion.imu = ReadName(map.Required("imu"));
  KnownParts parts = PartsAfterConversion(urdf, conversion, conversion.imu);
  if (const auto sensors = map.Optional("force_torque")) {
    ReadSensors(*sensors, urdf, parts.names.sites, &conversion);
  }
  if (const auto pairs = map.Optional("self_collision")) {
    ReadSelfCollision(*pairs, parts.names.bodies, &conversion);
  }
  parts = PartsAfterConversion(urdf, conversion, conversion.imu);
  ReadModelParts(map, parts, robot);
  for (const UrdfForceTorque& sensor : conversion.force_torque) {
    robot->force_torque.push_back(sensor.name);
  }
  for (const FootDescription& foot : robot->feet) conversion.foot_frames.push_back(foot.frame);
  UrdfMjcf drawn = UrdfToMjcf(urdf_file, conversion);
  conversion.has_visuals = false;
  robot->model =
      RobotModel{ModelLanguage::kUrdf, urdf_file, UrdfToMjcf(urdf_file, conversion).robot,
                 std::move(drawn.robot), std::move(drawn.ground_pairs)};
  CompileMjcf(robot->model->drawn_mjcf, "", urdf_file);
}

}  // namespace sidestep
