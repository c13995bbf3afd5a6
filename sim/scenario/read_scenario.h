// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_scenario: a scenario file and the command line's overrides, read strictly.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "models/robot_description/robot_faults.h"
#include "sim/scenario/renamed_keys.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// Reads a robot.yaml: ReadSoundRobot, or what remembers robots for it.
using RobotReader = std::function<RobotDescription(const std::filesystem::path& file)>;

/// Reads a scenario of format version 1 and the robot that it names, and checks that they fit.
///
/// @param file       The YAML file; it may be based on another (based_on.h). A robot named by a
///                   path is relative to the folder of the file that names it; by
///                   `--set robot=path`, to the current one.
/// @param overrides  Assignments `a.b=c` and `--push TEXT`, applied in order (see
///                   apply_override.h).
/// @param note       Told of keys under an old name, in the file, an override or the robot.yaml's
///                   `control` block.
/// @param read_robot Reads all of the robot but that block.
/// @throws ConfigError with `file:line:column`, or with `--set a.b=c` for an override's mistakes.
Scenario ReadScenario(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides = {}, const NoteSink& note = {},
                      const RobotReader& read_robot = ReadSoundRobot);

/// What a scenario's file, or the one it is based on, says of itself; its robot is not read.
/// @throws ConfigError with `file:line:column`.
ScenarioBasics ReadScenarioBasics(const std::filesystem::path& file);

/// A scenario of a robot alone, which has no file: two feet walk in place, one hops, in the gait's
/// defaults; on the centroidal plant, if the robot has no model.
///
/// @param robot      As a scenario's `robot` names it; a path is relative to the current folder.
/// @param overrides  As above.
/// @param note       As above.
/// @throws ConfigError, as above.
Scenario ScenarioOfRobot(const std::string& robot, const std::vector<std::string>& overrides = {},
                         const NoteSink& note = {});

/// Whether `word` is the path of a robot.yaml: a YAML file with a key `sidestep_robot`. False of
/// what can't be read.
bool IsRobotFile(const std::filesystem::path& word);

}  // namespace sidestep
