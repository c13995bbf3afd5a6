// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sagittal_plane: a robot whose base moves in the plane y = 0, and how the controller sees it.
//
// Such a robot's feet may have an area and stand side by side, but whatever they do sideways is
// borne by what keeps the robot in its plane. All that the ground can do for its motion happens in
// that plane: a sole's corners count by where they are along x and z of F.

#include "models/robot_description/robot_description.h"
#include "models/support/config_node.h"

namespace sidestep {

/// Finds out of the robot's model how its base floats and, if it is sagittal, where its feet are
/// beside the plane: sets base_freedom and every foot's lateral_m. Throws ConfigError, naming the
/// model's file, if joints, feet or CoM of a sagittal robot do not suit its plane: joints turn
/// about y or slide along x and z, the CoM is at y = 0, feet are as far to the left as to the right
/// (one alone is at 0) and face forward. @param feet  What is said about them is said at this place
/// of a robot.yaml instead, if there is one.
void FindSagittalPlane(RobotDescription* robot, const ConfigNode* feet = nullptr);

/// The robot as a controller plans for it. One that is not sagittal is left as it is. Of a sagittal
/// one the vertices are moved into the plane, along y of F; those that then coincide become one,
/// which takes the sum of their force_shares.
RobotDescription InItsPlane(const RobotDescription& robot);

}  // namespace sidestep
