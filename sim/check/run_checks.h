// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_checks: runs scenarios, each in a process of its own, several at once.
//
// By process, because the reference solver is not thread-safe and because a run that crashes must
// not take its neighbours along. The threads here only start processes and wait for them.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "sim/check/outcome.h"

namespace sidestep {

/// One scenario to run: its name, its file, the folder that its run is left in and its robot.
struct CheckItem {
  std::string name;
  std::filesystem::path file;
  std::filesystem::path run_dir;
  std::string robot{};
};

struct CheckPlan {
  std::vector<CheckItem> items;
  std::filesystem::path program;       ///< This program; `run` is asked of it.
  std::vector<std::string> arguments;  ///< Passed to every `run` after its own.
  int jobs{1};                         ///< Processes at once, >= 1.
  double time_limit_s{std::numeric_limits<double>::infinity()};  ///< Of each, on the wall.
  /// Called before a run starts: takes away what an earlier one left in its folder, or throws.
  std::function<void(const std::filesystem::path& run_dir)> clear{};
};

/// Told of every outcome as it arrives; never called twice at once.
using CheckListener = std::function<void(const Outcome& outcome, std::size_t num_done)>;

/// Runs all items; the outcomes are in the items' order. Once `stop` returns true no further run is
/// started, and those in progress are told to end (SIGTERM) and waited for. What was not started is
/// INVALID with reason INTERRUPTED; a run that takes longer than its limit is told to end, and is
/// INVALID unless its verdict stood already and only its pictures took so long.
/// `stop` is called from several threads.
std::vector<Outcome> RunChecks(const CheckPlan& plan, const std::function<bool()>& stop,
                               const CheckListener& listener);

}  // namespace sidestep
