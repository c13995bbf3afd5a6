// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_description.h"

#include <utility>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/mjcf_complaint.h"
#include "models/robot_description/mjcf_joints.h"
#include "models/robot_description/mjcf_names.h"
#include "models/robot_description/robot_parts.h"
#include "models/robot_description/sagittal_plane.h"
#include "models/robot_description/urdf_robot.h"
#include "models/support/config_error.h"
#include "models/support/config_node.h"

namespace sidestep {
namespace {

constexpr int kFormatVersion = 1;

void ReadVersion(ConfigMap& map) {
  const ConfigNode version = map.Required("sidestep_robot");
  if (version.Integer(0, 1000000) != kFormatVersion) {
    version.Fail("= " + version.Text() + " is a version that this program can't read; it reads 1");
  }
}

/// A base that moves in a plane can't start rolled or turned.
void RequirePlanarStart(const ConfigNode& rpy, const RobotDescription& robot) {
  const bool is_planar = robot.base_freedom == BaseFreedom::kSagittal;
  if (is_planar && (robot.base_rpy_rad.x() != 0.0 || robot.base_rpy_rad.z() != 0.0)) {
    rpy.Fail("must be [0, pitch, 0]: this base moves in a plane");
  }
}

/// That what is simulated compiles where the MJCF itself does.
void RequireCompiles(const RobotModel& model) {
  try {
    CompileMjcf(model.simulated_mjcf, "", model.file);
  } catch (const ConfigError&) {
    RefuseAssetFiles(model.file);
    throw;
  }
}

/// The keys of a robot that has an MJCF.
void ReadMjcfRobot(ConfigMap& map, RobotDescription* robot) {
  const ConfigNode mjcf = map.Required("mjcf");
  const std::filesystem::path file =
      (robot->file.parent_path() / ReadName(mjcf)).lexically_normal();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    mjcf.Fail("= '" + mjcf.Text() + "' is no file beside this one");
  }
  if (const auto mass = map.Optional("mass_kg")) {
    mass->Fail("is told by the MJCF; leave it out");
  }
  robot->model = ReadMjcfModel(file);
  const KnownParts parts{ModelLanguage::kMjcf, ReadMjcfNames(file)};
  RequireCompiles(*robot->model);
  ReadModelParts(map, parts, robot);
  if (const auto joints = map.Optional("joints")) ReadMjcfJoints(*joints, parts, robot);
  const ConfigNode feet = map.Required("feet");
  FindSagittalPlane(robot, &feet);
  if (const auto rpy = map.Optional("base_rpy_rad")) RequirePlanarStart(*rpy, *robot);
  for (const FootDescription& foot : robot->feet) {
    robot->force_torque.insert(robot->force_torque.end(), foot.force_torque.begin(),
                               foot.force_torque.end());
  }
  robot->force_torque.insert(robot->force_torque.end(), robot->arm_force_torque.begin(),
                             robot->arm_force_torque.end());
}

/// The keys of a robot of the centroidal plant: a point mass, so base, imu and joints mean nothing.
void ReadCentroidalRobot(ConfigMap& map, RobotDescription* robot) {
  const ConfigNode mass = map.Required("mass_kg");
  robot->mass_kg = mass.Number(0.0, kMaxMass_kg);
  if (robot->mass_kg <= 0.0) mass.Fail("must be greater than 0");
  robot->feet = ReadFeet(map.Required("feet"), nullptr);
  for (const char* key : {"base", "imu", "home", "base_height_m"}) {
    if (map.Optional(key)) {
      map.FailAtKey(key, "means nothing for a robot without an mjcf or a urdf");
    }
  }
}

}  // namespace

RobotDescription ReadRobotDescription(const std::filesystem::path& file) {
  const ConfigTree tree = ReadConfigFile(file);
  ConfigMap map(tree, "");
  RobotDescription robot;
  robot.file = std::filesystem::absolute(file).lexically_normal();
  ReadVersion(map);
  robot.name = map.Required("name").Word();
  robot.com_height_m = map.Required("com_height_m").Number(0.01, kMaxLength_m);
  if (map.Optional("urdf")) {
    if (map.Optional("mjcf")) map.FailAtKey("mjcf", "can't be beside a urdf");
    ReadUrdfRobot(map, &robot);
  } else if (map.Optional("mjcf")) {
    ReadMjcfRobot(map, &robot);
  } else {
    ReadCentroidalRobot(map, &robot);
  }
  map.Optional("control");         // gains of this robot: ReadScenario reads them, as
  map.Optional("control_torque");  // what stands on top of them where torques drive it
  map.RejectUnknownKeys();
  return robot;
}

const RobotModel& RequireModel(const RobotDescription& robot) {
  if (robot.model) return *robot.model;
  throw ConfigError(robot.file.string() + ": error: needs an mjcf or a urdf");
}

RobotNames NamesIn(const RobotDescription& description) {
  RobotNames names;
  if (description.model) {
    const RobotModel& model = *description.model;
    MjcfNames parts = NamesOf(*CompileMjcf(model.simulated_mjcf, "", model.file));
    return {std::move(parts.bodies), std::move(parts.sites), std::move(parts.unfit_motors)};
  }
  names.bodies.emplace_back("com");
  for (const FootDescription& foot : description.feet) names.frames.push_back(foot.frame);
  return names;
}

}  // namespace sidestep
