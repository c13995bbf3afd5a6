// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_folder: from the command line of a sweep to its plan in a folder.

#include <filesystem>

#include "sim/apps/commands/sweep_options.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep {

/// The sweep that is asked for. @throws ConfigError as ReadSweep, and if it has more than a million
/// runs that nobody agreed to.
SweepSpec ReadTarget(const SweepArguments& arguments);

/// Where it goes: as told, or renders/<name>.
std::filesystem::path FolderOf(const SweepArguments& arguments, const SweepSpec& spec);

/// Plans it there, or reads the plan that is there. @throws ConfigError as HoldsPlan.
SweepPlan PlanIn(const std::filesystem::path& folder, const SweepSpec& spec, bool is_quiet);

/// `sweep slurm`.
void AddSlurmCommand(CLI::App& sweep, int& exit_code);

}  // namespace sidestep
