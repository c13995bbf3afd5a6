// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// looks: what a robot is drawn with. Nothing here takes part in the simulation.

#include <filesystem>
#include <vector>

#include "models/support/file_notes.h"
#include "models/urdf_to_mjcf/body_tree.h"

namespace sidestep {

/// Finds the meshes of visual shapes in `folders`; those that can't be drawn stay without
/// MeshReference::mjcf, with a notice for each reason. Hides collision shapes of links that have a
/// visual one. Gives a body that has nothing to see a stick to each joint and welded body on it or,
/// where there is none, the box that has its mass and inertia.
void FindLooks(const std::vector<std::filesystem::path>& folders, Body* base, FileNotes* notes);

}  // namespace sidestep
