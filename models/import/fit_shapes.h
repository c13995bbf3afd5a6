// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fit_shapes: boxes and capsules that stand for meshes and for links without a shape.

#include <vector>

#include "models/import/mesh.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// The box or the capsule (as a cylinder longer than wide) around the points, whichever holds less
/// room, along their principal axes. The points are in the frame in which the shape is posed.
SourceShape FitShape(const std::vector<Eigen::Vector3d>& points);

/// The homogeneous box with this inertia, in the link's frame. Requires a possible inertia.
SourceShape BoxOfInertia(const MassProperties& mass);

/// The same with the axes R_LB in the link instead of the principal ones; products of inertia about
/// them are passed over.
SourceShape BoxOfInertia(const MassProperties& mass, const Eigen::Matrix3d& R_LB);

/// Vertices of a shape's surface, in the link: a mesh's own, corners of a box, rims of a cylinder;
/// a sphere has none but its middle.
std::vector<Eigen::Vector3d> SurfaceOf(const SourceShape& shape, const Mesh* mesh);

/// Whether a shape that is no mesh has no volume, as points that mark contacts have: none collides.
bool IsEmpty(const SourceShape& shape);

}  // namespace sidestep::importer
