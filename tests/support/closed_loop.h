// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// closed_loop: runs a shipped scenario in this process and hands back what it showed.

#include <filesystem>
#include <string>
#include <vector>

#include "sim/episode/run_scenario.h"
#include "sim/scenario/read_scenario.h"
#include "tests/support/temp_folder.h"

namespace sidestep {

/// One run, with its folder for as long as this object lives.
struct ClosedLoopRun {
  TempFolder folder;
  Verdict verdict;

  /// Reads scenarios/<name>.yaml of the source tree with `overrides`, and runs it.
  explicit ClosedLoopRun(const std::string& name, const std::vector<std::string>& overrides = {}) {
    const std::filesystem::path file =
        std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios" / (name + ".yaml");
    RunOptions options;
    options.out_dir = folder.path();
    verdict = RunScenario(ReadScenario(file, overrides), options).verdict;
  }

  /// Verdict and reasons in one line, for messages.
  std::string Describe() const {
    std::string text(EnumName(verdict.verdict_class));
    for (const Reason& reason : verdict.reasons) text += "; " + reason.kind + ": " + reason.text;
    return text;
  }

  /// True if the run failed and the first reason is of `kind`.
  bool FailedBy(const std::string& kind) const {
    return verdict.verdict_class == VerdictClass::kFail && !verdict.reasons.empty() &&
           verdict.reasons.front().kind == kind;
  }
};

}  // namespace sidestep
