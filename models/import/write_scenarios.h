// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_scenarios: an imported robot's first scenarios: it stands, walks, and is pushed.

#include <map>
#include <string>

#include "models/import/imported_robot.h"

namespace sidestep::importer {

/// Texts by file name: NAME_stand.yaml, NAME_walk.yaml, NAME_push.yaml. Their robot is the
/// robot.yaml beside them.
std::map<std::string, std::string> ScenarioTexts(const ImportedRobot& imported);

}  // namespace sidestep::importer
