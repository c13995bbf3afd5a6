// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_urdf: a SourceRobot as URDF text that a person can read.

#include <string>

#include "models/import/source_robot.h"

namespace sidestep::importer {

/// A whole document. Links come before the joints that they hang on, parents first; what was
/// changed is a comment. Numbers have twelve significant digits: a mass or an inertia reads back
/// to 1e-12 of itself. @param source  What it was made from, for the comment on top.
std::string UrdfText(const SourceRobot& robot, const std::string& source);

}  // namespace sidestep::importer
