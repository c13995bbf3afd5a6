// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_scenarios: an imported robot's first scenarios: it stands, walks, and is pushed.

#include <map>
#include <string>

#include "models/import/imported_robot.h"
#include "models/robot_description/robot_description.h"

namespace sidestep::importer {

/// Texts by file name: NAME_stand.yaml, NAME_walk.yaml, NAME_push.yaml. Their robot is the
/// robot.yaml beside them.
std::map<std::string, std::string> ScenarioTexts(const ImportedRobot& imported);

/// The same of a robot that was not made here; none if it is no humanoid on two soles and servos.
/// Its feet stay as far apart as they start.
std::map<std::string, std::string> ScenariosOf(const RobotDescription& robot);

}  // namespace sidestep::importer
