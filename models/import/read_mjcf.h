// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_mjcf: a maker's MJCF, a scene with its robot or the robot alone, as a SourceRobot.
//
// Flow: file -> [xml_tree] -> [mjcf_rewrite: ours of it, in our MuJoCo's words] -> MuJoCo's
// compiler -> mjModel -> [mjcf_bodies, mjcf_shapes, mjcf_motors] -> SourceRobot. Classes, angles,
// inertias of shapes and all else that has a default are MuJoCo's business.

#include <filesystem>

#include "models/import/mesh_files.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Whether the file's outermost element is <mujoco>. Throws ConfigError if it can't be read.
bool IsMjcf(const std::filesystem::path& file);

/// Reads. `files` gets the meshes. Throws ConfigError with every problem that was found before
/// MuJoCo's compiler, else with the one that it stopped at; each as `file:line:column: error: ...`.
SourceRobot ReadMjcf(const std::filesystem::path& file, MeshFiles* files, Notes* notes);

}  // namespace sidestep::importer
