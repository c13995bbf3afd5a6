// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_source: a maker's URDF, element by element. It takes what the simulation couldn't.
//
// In : a URDF with meshes, mimic joints, links without mass, tags of other programs.
// Out: SourceRobot. No file but the URDF is opened; nothing recurses, however deep the file nests.

#include <filesystem>

#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Reads `urdf`. A root without mass under a floating joint is left out: the base floats anyway.
/// What other programs read (transmission, gazebo, sensor ...) is passed over; `notes` says so.
/// Throws ConfigError with every problem in a line `file:line:column: error: ...`: bad XML or
/// numbers, names that are missing, unknown or there twice, joints that form no tree, planar
/// joints, a file of xacro, more than xml_bounds.h allows, or more than 2000 links.
SourceRobot ReadSource(const std::filesystem::path& urdf, Notes* notes);

}  // namespace sidestep::importer
