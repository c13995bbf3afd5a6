// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// find_scenarios: the scenario files that paths on the command line mean.

#include <filesystem>
#include <vector>

namespace sidestep {

/// Whether folders are searched for sweeps' files too.
enum class SweepFiles { kSkipped, kFound };

/// Files as given, folders searched for *.yaml at any depth, bare names of shipped scenarios;
/// sorted by path, each file once. A search passes over robots' files and over folders of runs and
/// sweeps, which hold copies of scenarios, and doesn't follow links to folders.
/// @throws ConfigError for what is none of them, for a folder without one and for one that can't be
/// read.
std::vector<std::filesystem::path> FindScenarios(const std::vector<std::filesystem::path>& paths,
                                                 SweepFiles sweeps = SweepFiles::kSkipped);

}  // namespace sidestep
