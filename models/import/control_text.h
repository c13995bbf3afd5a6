// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// control_text: the `control` block of an imported robot.yaml.

#include <string>

#include "models/import/imported_robot.h"

namespace sidestep::importer {

/// Defaults of a scenario's `control`, and what changes with its mode: on soles those of
/// generic_humanoid, on points those that Bolt walks with, scaled to the robot's mass and height.
std::string ControlText(const ImportedRobot& imported);

}  // namespace sidestep::importer
