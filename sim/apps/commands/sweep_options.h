// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_options: the command line of `sweep` and of its parts, as plain data.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "sim/sweep/read_sweep.h"
#include "sim/sweep/run_shard.h"

namespace sidestep {

struct SweepArguments {
  std::filesystem::path target;
  std::filesystem::path folder;  ///< Empty: renders/<name>.
  SweepOptions sweep;
  ShardOptions shard;
  std::string shard_text;  ///< I/N, or auto; empty: all.
  std::string keep{"none"};
  int evidence{0};
  bool is_agreed{false};
  bool is_quiet{false};
};

/// Arguments for `command`, with a process a core and its --quiet.
std::shared_ptr<SweepArguments> NewSweepArguments(CLI::App& command);

/// The positional SWEEP and --out.
void AddSweepTarget(CLI::App& command, SweepArguments& arguments);

/// --vary and all else that says what is swept.
void AddSweepSpecOptions(CLI::App& command, SweepArguments& arguments);

/// --evidence: how many of a map's worst cells are shown (map/evidence.h).
void AddEvidenceOption(CLI::App& command, int& evidence);

/// --jobs, --keep, --log and --time-budget.
void AddSweepRunOptions(CLI::App& command, SweepArguments& arguments);

}  // namespace sidestep
