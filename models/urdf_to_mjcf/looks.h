// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// looks: what a robot is drawn with. Nothing here takes part in the simulation.

#include <filesystem>
#include <vector>

#include "models/support/file_notes.h"
#include "models/urdf_to_mjcf/body_tree.h"

namespace sidestep {

/// Finds the meshes of visual shapes in `folders`; those that can't be drawn stay without
/// MeshReference::mjcf, with a notice for each reason. Hides collision shapes of links that have
/// something else to look at. A body whose meshes are missing, or that has no shape, gets sticks
/// from its joint to the joints and welded bodies on it and to its collision shapes or, where there
/// are none, the box that has its mass and inertia.
void FindLooks(const std::vector<std::filesystem::path>& folders, Body* base, FileNotes* notes);

}  // namespace sidestep
