// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// find_scenario: the file that a scenario's name on the command line means.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

/// Names of the scenarios that ship with the program (their files without `.yaml`), sorted.
std::vector<std::string> ShippedScenarios();

/// The scenario file that `word` means: a path to what is there and no folder, or else a shipped
/// scenario by its bare name, with `.yaml` or without. So a file of one's own goes before one that
/// ships.
/// @throws ConfigError, which names a shipped scenario that looks like it, if it is neither.
std::filesystem::path FindScenario(const std::filesystem::path& word);

/// The file of a shipped scenario, by its name with `.yaml` or without; empty if none has it.
std::filesystem::path FindShippedScenario(const std::filesystem::path& name);

/// The key that a sweep's file begins with, where a scenario's has `sidestep`.
inline constexpr const char* kSweepKey = "sidestep_sweep";

/// Whether `file` is a sweep's (see `sidestep sweep`) and no scenario; what can't be read is none.
bool IsSweepFile(const std::filesystem::path& file);

}  // namespace sidestep
