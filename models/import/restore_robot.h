// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// restore_robot: the robot that an exported MJCF carries, as it was: whole, or not at all.

#include <optional>

#include "models/import/import_robot.h"

namespace sidestep::importer {

/// Writes the files of the robot that the source carries, and scenarios for it. Empty if it carries
/// none. Throws ConfigError, and has written nothing, where the options ask for something else than
/// the robot as it was, or its files are no sound robot.
std::optional<ImportReport> RestoreRobot(const ImportOptions& options);

}  // namespace sidestep::importer
