// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_urdf: a URDF file as a tree of bodies with mass. The only place that knows urdfdom.

#include <filesystem>
#include <string>
#include <vector>

#include "models/urdf_to_mjcf/body_tree.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

namespace sidestep {

/// The tree under the base, and what the URDF says of the motors.
struct UrdfTree {
  Body base;
  std::vector<UrdfJointInfo> joints;  ///< That move, locked ones among them; parents first.
};

/// Reads the file. Joints called in `locked_joints` become welds at zero. Links without mass become
/// frames of the body that they are fixed to; links before the first one with mass are frames of
/// the base. Throws ConfigError, see ReadUrdfParts.
UrdfTree ReadUrdf(const std::filesystem::path& urdf, const std::vector<std::string>& locked_joints);

}  // namespace sidestep
