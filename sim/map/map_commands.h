// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// map_commands: the command that repeats a cell.

#include <string>

#include "sim/map/sweep_map.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep::map {

/// A word for a POSIX shell, which takes it as it is.
std::string ShellWord(const std::string& word);

/// `sidestep run ...` that repeats a run of the sweep.
std::string RunCommand(const SweepSpec& spec, const Ray& ray, const CellKey& cell);

/// Fills in every cell's commands: of the greatest strength that survived, and of the smallest that
/// was lost; of all without a limit the first.
void AddCommands(const SweepPlan& plan, SweepMap* map);

}  // namespace sidestep::map
