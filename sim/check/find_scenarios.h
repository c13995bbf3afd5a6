// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// find_scenarios: the scenario files that paths on the command line mean.

#include <filesystem>
#include <vector>

namespace sidestep {

/// Whether folders are searched for sweeps' files too.
enum class SweepFiles { kSkipped, kFound };

/// Files as given, folders searched for *.yaml at any depth, bare names of shipped scenarios;
/// sorted by path, each file once.
/// @throws ConfigError for what is none of them and for a folder without one.
std::vector<std::filesystem::path> FindScenarios(const std::vector<std::filesystem::path>& paths,
                                                 SweepFiles sweeps = SweepFiles::kSkipped);

}  // namespace sidestep
