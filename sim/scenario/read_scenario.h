// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_scenario: a scenario file and the command line's overrides, read strictly.

#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario/renamed_keys.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// Reads a scenario of format version 1 and the robot that it names, and checks that they fit.
///
/// @param file       The YAML file. A robot named by a path is relative to the file's folder;
///                   by `--set robot=path`, to the current one.
/// @param overrides  Assignments `a.b=c`, applied in order (see apply_override.h).
/// @param note       Told of keys under an old name, in the file, an override or the robot.yaml's
///                   `control` block.
/// @throws ConfigError with `file:line:column`, or with `--set a.b=c` for an override's mistakes.
Scenario ReadScenario(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides = {}, const NoteSink& note = {});

}  // namespace sidestep
