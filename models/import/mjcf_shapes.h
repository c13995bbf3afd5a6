// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_shapes: geoms of a compiled MJCF as shapes of links.

#include <mujoco/mujoco.h>

#include "models/import/mesh_files.h"
#include "models/import/mjcf_bodies.h"

namespace sidestep::importer {

/// Gives the links of `bodies` their shapes. What collides by its contype or conaffinity, or in a
/// <pair>, is a collision shape (if nothing does so, what is hidden in group 3 and more: some
/// robots get their pairs from the scene around them); what does not, and is in one of the groups 0
/// to 2 that MuJoCo draws, is looked at. A link that would not be seen so shows what collides.
/// Ellipsoids become boxes or capsules around them. `files` gets the triangles of meshes, as MuJoCo
/// turned and scaled them.
void TakeShapes(const mjModel& model, MjcfBodies* bodies, MeshFiles* files, Notes* notes);

}  // namespace sidestep::importer
