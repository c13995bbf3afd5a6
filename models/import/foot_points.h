// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// foot_points: what a foot consists of, seen from it: its surface, and frames of its maker's.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "models/import/fit_sole.h"
#include "models/import/mesh_files.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// One of a link's two lists of shapes.
using Shapes = std::vector<SourceShape> SourceLink::*;

/// Surface of a shape whose link is posed by X_FL in the foot's frame F. Of a cylinder longer than
/// wide, which is a capsule here, the two balls at its ends.
std::vector<SurfacePoint> ShapePoints(const SourceShape& shape, const Eigen::Isometry3d& X_FL,
                                      MeshFiles* meshes);

/// Of all such shapes of a foot and of what it carries, with all joints at zero.
std::vector<SurfacePoint> FootPoints(const SourceRobot& robot, int foot, Shapes shapes,
                                     MeshFiles* meshes);

/// The maker's frame at X_FS of the foot: fixed to it, without mass or shape, as level, and off by
/// no more than `most_off_m` along each axis of S. -1 where there is none; else its notes say so.
int MakersFrameAt(const SourceRobot& robot, int foot, const Eigen::Isometry3d& X_FS,
                  const Eigen::Vector3d& most_off_m, Notes* notes);

}  // namespace sidestep::importer
