// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_robot_yaml: an imported robot as the text of its robot.yaml, with comments for a person.

#include <string>

#include "models/import/imported_robot.h"

namespace sidestep::importer {

/// Lines that begin with `# decide:` are for a person; all else was found out or chosen.
std::string RobotYamlText(const ImportedRobot& imported);

/// A name as YAML takes it for a text, quoted where it must be.
std::string YamlText(const std::string& name);

}  // namespace sidestep::importer
