// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_description: what robot.yaml says of a robot, beside its model in MJCF or URDF.

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "models/mjcf/base_joints.h"
#include "models/robot_description/mjcf_names.h"
#include "models/robot_description/robot_model.h"

namespace sidestep {

/// One foot. Its frame F is a site of the MJCF (or a point of the centroidal plant); the site's
/// body, with all that is welded to it, is the foot, and all that may touch the ground. The foot
/// feels the ground by the force/torque sensors it names or, if it names none, by a touch sensor
/// called
/// `<name>_touch`.
struct FootDescription {
  std::string name;
  std::string frame;                      ///< Site F.
  std::vector<std::string> force_torque;  ///< Of RobotDescription::force_torque.
  Eigen::Matrix3Xd vertices_m;  ///< 3 x n_v, in F; one column at the origin is a point foot.
  double sole_height_m{0.0};    ///< Height of F above the ground while the foot stands.
  /// n_v, sum 1, from preferred_cop_m: how the MPC likes the foot's force shared between its
  /// vertices. Empty: equally, which prefers the vertices' mean.
  Eigen::VectorXd force_shares{};
  /// Of a robot whose base moves in the plane y = 0: where F is beside it, for good; else 0.
  double lateral_m{0.0};
};

/// What robot.yaml adds to an actuated joint. The servo is what stands between a position reference
/// and the joint's torque: stiffness (q_ref - q) + damping (v_ref - v), within the motor's limit.
struct JointDescription {
  std::string name;
  double servo_stiffness_Nm_per_rad{0.0};
  double servo_damping_Nms_per_rad{0.0};
  double velocity_limit_radps{0.0};
  double posture_weight{1.0};  ///< Of the whole-body posture task.
};

/// A robot as the program loads it. Its model has sensors `<imu>_orientation` (framequat),
/// `<imu>_gyro` and `<imu>_accelerometer` at site `<imu>`, `<name>_force` and `<name>_torque` at
/// site
/// `<name>` for every force/torque sensor, and one motor an actuated joint.
struct RobotDescription {
  std::string name;
  std::filesystem::path file;       ///< The robot.yaml it was read from.
  std::optional<RobotModel> model;  ///< Absent: it lives on the centroidal plant only.
  double mass_kg{0.0};              ///< Given only when there is no model to tell it; else 0.
  std::string base;                 ///< Body B that floats; base_joints.h tells how it may.
  BaseFreedom base_freedom{BaseFreedom::kFree};  ///< What its joints in the model leave it.
  std::string imu;                               ///< Site U.
  std::string torso;         ///< Site whose orientation the whole-body control holds; may be empty.
  double com_height_m{0.0};  ///< Nominal CoM above the ground.
  double base_height_m{0.0};  ///< Base origin above the ground at the start.
  Eigen::Vector3d base_rpy_rad{Eigen::Vector3d::Zero()};  ///< Base attitude at the start.
  std::vector<JointDescription> joints;   ///< In the order of the actuators; empty without servos.
  std::vector<std::string> force_torque;  ///< Sensors, each at a site of its name.
  std::vector<std::string> arm_force_torque;  ///< Those of them that feel what is done to the arms.
  std::map<std::string, double> home;  ///< Joint positions at the start (rad or m); 0 if absent.
  std::vector<FootDescription> feet;   ///< At least one.
  /// What the model's file has that was harmless, and how it was taken:
  /// `file:line:column: notice: ...`. Empty for robots that ship.
  std::vector<std::string> notices{};
};

/// The robot's model. Throws ConfigError naming robot.file if it has none.
const RobotModel& RequireModel(const RobotDescription& robot);

/// Reads a robot.yaml, but for its `control` block: this robot's own defaults of a scenario's
/// `control`, which only ReadScenario understands. Throws ConfigError with file:line:column.
RobotDescription ReadRobotDescription(const std::filesystem::path& file);

/// Finds the robot.yaml that `robot` names: a folder of the shipped models, or a path to a
/// robot.yaml relative to `relative_to`. Returns an empty path when there is none.
std::filesystem::path FindRobot(const std::string& robot, const std::filesystem::path& relative_to);

/// Names of the robots that ship with the program, sorted.
std::vector<std::string> ShippedRobots();

/// Bodies and sites of the robot's model; for a centroidal-only robot, {"com"} and its feet.
struct RobotNames {
  std::vector<std::string> bodies;
  std::vector<std::string> frames;
  std::vector<UnfitMotor> unfit_motors;  ///< For control by torque.
};

/// Compiles the model to list its names. Throws ConfigError with MuJoCo's message if it can't.
RobotNames NamesIn(const RobotDescription& description);

}  // namespace sidestep
