// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/urdf_robot.h"

#include <algorithm>
#include <utility>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_parts.h"
#include "models/robot_description/urdf_motors.h"
#include "models/urdf_to_mjcf/read_urdf.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

namespace sidestep {
namespace {

constexpr double kMaxEffort_Nm = 1e4;  // of a URDF; more is what is written where nobody knew
constexpr ModelLanguage kUrdf = ModelLanguage::kUrdf;
constexpr char kFrame[] = "link without mass";

/// Frames of the feet, before all that is said of feet is read.
std::vector<std::string> ReadFootFrames(ConfigMap& map) {
  std::vector<std::string> frames;
  for (const ConfigNode& foot : map.Required("feet").List()) {
    frames.push_back(ReadName(foot.Map().Required("frame")));
  }
  return frames;
}

/// Throws ConfigError with all that is wrong in the URDF; else keeps what was harmless.
UrdfTree ReadTree(const std::filesystem::path& urdf_file, const UrdfConversion& conversion,
                  RobotDescription* robot) {
  UrdfTree tree = SurveyFor(urdf_file, conversion);
  FileNotes& notes = tree.notes;
  for (const UrdfJointInfo& joint : tree.joints) {
    const auto actuator =
        std::find_if(conversion.actuators.begin(), conversion.actuators.end(),
                     [&](const UrdfActuator& other) { return other.joint == joint.name; });
    const bool is_asked_for =
        actuator != conversion.actuators.end() && actuator->torque_limit_Nm == joint.effort_Nm;
    if (is_asked_for && joint.effort_Nm > kMaxEffort_Nm) {
      notes.Problem(joint.place, "joint '" + joint.name +
                                     "' has effort = " + NumberText(joint.effort_Nm) +
                                     ", more than any motor's " + NumberText(kMaxEffort_Nm) +
                                     " Nm; mend it, or give its group in robot.yaml a "
                                     "torque_limit_Nm");
    }
  }
  notes.ThrowProblems();
  robot->notices = notes.notices();
  return tree;
}

/// The robot's own folders and the one that it may name for its meshes.
std::vector<std::filesystem::path> ReadMeshFolders(ConfigMap& map,
                                                   const std::filesystem::path& urdf_file,
                                                   const RobotDescription& robot) {
  const std::filesystem::path own = robot.file.parent_path();
  std::vector<std::filesystem::path> folders{own, urdf_file.parent_path()};
  if (const auto meshes = map.Optional("meshes")) {
    folders.push_back(own / ReadName(*meshes));
    std::error_code ignored;
    if (!std::filesystem::is_directory(folders.back(), ignored)) {
      meshes->Fail("= '" + meshes->Text() + "' is no folder");
    }
  }
  return folders;
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
  conversion.foot_frames = ReadFootFrames(map);
  conversion.mesh_folders = ReadMeshFolders(map, urdf_file, *robot);
  const UrdfTree tree = ReadTree(urdf_file, conversion, robot);
  RequireMotors(map, urdf, *robot, conversion);
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
  const std::string name = urdf_file.stem().string();
  UrdfMjcf drawn = Convert(tree, name, conversion);
  conversion.has_visuals = false;
  robot->model = RobotModel{ModelLanguage::kUrdf, urdf_file, Convert(tree, name, conversion).robot,
                            std::move(drawn.robot), std::move(drawn.ground_pairs)};
  CompileMjcf(robot->model->simulated_mjcf, "", urdf_file);  // without waiting for meshes
}

}  // namespace sidestep
