// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// scenario_list: what `sidestep scenarios` prints.

#include <string>

namespace sidestep {

/// A row for each scenario that ships: name, robot, simulated seconds, description; sorted by name.
/// @throws ConfigError if one can't be read.
std::string ScenariosText();

/// The same as a JSON list of objects with `name`, `robot`, `duration_s`, `description`, `file`.
std::string ScenariosJson();

}  // namespace sidestep
