// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// replace_meshes: what collides becomes boxes and capsules; what is drawn, small STL files.

#include <filesystem>

#include "models/import/mesh_files.h"
#include "models/import/posture.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Every mesh that collides becomes a shape fitted to its vertices or, where the file can't be
/// read, the box of its link's inertia. Shapes without volume are left out. Feet have been seen to
/// before.
void ReplaceCollisionMeshes(MeshFiles* meshes, SourceRobot* robot, Notes* notes);

/// Takes out shapes of links other than `feet` (and all that these carry) that would touch the
/// ground in the start pose: a leg stands on its soles alone.
void DropShapesInTheGround(const Posture& start, const std::vector<int>& feet, SourceRobot* robot,
                           Notes* notes);

/// Writes every visual mesh, decimated, to `folder`/meshes and refers to it as meshes/NAME.stl; a
/// mesh that can't be read, or none at all if not `is_wanted`, is left out. A link that loses all
/// its visual shapes so is drawn by its collision shapes.
void WriteVisualMeshes(const std::filesystem::path& folder, bool is_wanted, MeshFiles* meshes,
                       SourceRobot* robot, Notes* notes);

}  // namespace sidestep::importer
