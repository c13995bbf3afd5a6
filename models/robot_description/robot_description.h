// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_description: what robot.yaml says of a robot, beside its MJCF.

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sidestep {

/// One foot. Its frame F is a site of the MJCF (or a point of the centroidal plant); the site's body
/// is the foot, and all that may touch the ground. The MJCF has a touch sensor called `<name>_touch`.
struct FootDescription {
  std::string name;
  std::string frame;            ///< Site F.
  Eigen::Matrix3Xd vertices_m;  ///< 3 x n_v, in F; one column at the origin is a point foot.
  double sole_height_m{0.0};    ///< Height of F above the ground while the foot stands.
};

/// A robot as the program loads it. The MJCF has sensors `<imu>_orientation` (framequat),
/// `<imu>_gyro` and `<imu>_accelerometer` at site `<imu>`, and one motor an actuated joint.
struct RobotDescription {
  std::string name;
  std::filesystem::path file;  ///< The robot.yaml it was read from.
  std::filesystem::path mjcf;  ///< Absolute; empty for a robot of the centroidal plant only.
  double mass_kg{0.0};         ///< Given only when there is no MJCF to tell it; else 0.
  std::string base;            ///< Body B that carries the free joint.
  std::string imu;             ///< Site U.
  double com_height_m{0.0};    ///< Nominal CoM above the ground.
  double base_height_m{0.0};   ///< Base origin above the ground at the start.
  std::map<std::string, double> home;  ///< Joint positions at the start (rad or m); 0 if absent.
  std::vector<FootDescription> feet;   ///< At least one.
};

/// Reads a robot.yaml, but for its `control` block: this robot's own defaults of a scenario's
/// `control`, which only ReadScenario understands. Throws ConfigError with file:line:column.
RobotDescription ReadRobotDescription(const std::filesystem::path& file);

/// Finds the robot.yaml that `robot` names: a folder of the shipped models, or a path to a
/// robot.yaml relative to `relative_to`. Returns an empty path when there is none.
std::filesystem::path FindRobot(const std::string& robot, const std::filesystem::path& relative_to);

/// Names of the robots that ship with the program, sorted.
std::vector<std::string> ShippedRobots();

/// Bodies and sites of the robot's MJCF; for a centroidal-only robot, {"com"} and its feet.
struct RobotNames {
  std::vector<std::string> bodies;
  std::vector<std::string> frames;
};

/// Compiles the MJCF to list its names. Throws ConfigError with MuJoCo's message if it can't.
RobotNames NamesIn(const RobotDescription& description);

}  // namespace sidestep
