// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_bodies: a compiled MJCF's bodies and joints as links and joints of a URDF.
//
// A link's origin is on its joint's axis and an MJCF's need not be: links are moved there. Of
// several joints of a body all but the last get a link of their own, of a millionth of a gram. A
// body without joints is a link on a fixed joint or, without a name, part of its parent's link.

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <vector>

#include "models/import/mjcf_rewrite.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Links, joints and what was which in the model.
struct MjcfBodies {
  SourceRobot robot;                    ///< Without shapes; connected.
  std::vector<int> link;                ///< Of each body; -1: not of the robot.
  std::vector<Eigen::Isometry3d> X_LB;  ///< Of each body in its link.
  std::vector<int> joint;               ///< Of each joint of the model; -1: none.
};

/// The robot is the child of the world with hinges that weighs most; whatever joins it to the world
/// is a floating base. Positions count from where the model is posed at first (`ref`).
/// Sites become links without mass. Balls, and a world without hinges, are problems.
/// @param file  For the problems' places of what has none of its own.
MjcfBodies TakeBodies(const mjModel& model, const MjcfParts& parts, const std::string& file,
                      Problems* problems, Notes* notes);

}  // namespace sidestep::importer
