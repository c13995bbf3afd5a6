// SPDX-License-Identifier: BSD-3-Clause
#include "sim/apps/commands/sweep_folder.h"

#include <cstdio>

#include "models/support/config_error.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/progress.h"
#include "sim/process/interrupt.h"

namespace sidestep {
namespace {

constexpr double kManyCells = 1e6;  // more of them want --yes

}  // namespace

// Cells are counted before any is listed: there may be more than memory holds.
SweepSpec ReadTarget(const SweepArguments& arguments) {
  const EndsAtOnce reading(kExitInvalid);
  SweepSpec spec = ReadSweep(arguments.target, arguments.sweep);
  const double cells = NumCells(spec);
  if (cells > kManyCells && !arguments.is_agreed) {
    char count[32];
    std::snprintf(count, sizeof count, "%.3g", cells);
    throw ConfigError("error: this sweep may have " + std::string(count) +
                      " runs; --yes if that is meant");
  }
  return spec;
}

std::filesystem::path FolderOf(const SweepArguments& arguments, const SweepSpec& spec) {
  return arguments.folder.empty() ? std::filesystem::path("renders") / spec.name : arguments.folder;
}

namespace {

// Reads the first cell of every ray.
SweepPlan Planned(const SweepSpec& spec, bool is_quiet) {
  const EndsAtOnce reading(kExitInvalid);
  Progress progress("plan", is_quiet);
  return MakePlan(spec, [&](double share) { progress.Update(share, ""); });
}

}  // namespace

SweepPlan PlanIn(const std::filesystem::path& folder, const SweepSpec& spec, bool is_quiet) {
  if (HoldsPlan(spec, folder)) return ReadPlan(folder);
  const SweepPlan plan = Planned(spec, is_quiet);
  WritePlan(plan, folder);
  return plan;
}

}  // namespace sidestep
