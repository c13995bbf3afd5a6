// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// home_pose: where a robot is when a run begins. Plant and controller must agree on it.

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <string>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Writes the configuration at the start into `data->qpos`: joints at robot.home (0 where it
/// names none), the base at its height and attitude and at rest, the midpoint of the feet over the
/// world's origin (a base that moves in a plane stays in it). Leaves `data` with the kinematics of
/// that configuration. Throws ConfigError for names that the model lacks.
void PlaceAtHome(const mjModel& model, const RobotDescription& robot, mjData* data);

/// A robot's simulated model as PlaceAtHome() leaves it, to be asked where its parts are.
class HomePose {
 public:
  /// Throws ConfigError like PlaceAtHome(), and if the robot has no model.
  explicit HomePose(const RobotDescription& robot);

  /// Pose in W of a frame (site) or, where none is called so, a body. Throws ConfigError.
  Eigen::Isometry3d X_WO(const std::string& name) const;

 private:
  MjModelPtr model_;
  MjDataPtr data_;
};

}  // namespace sidestep
