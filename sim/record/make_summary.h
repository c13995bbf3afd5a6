// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// make_summary: gathers what a run amounts to into a RunSummary.

#include <string>
#include <utility>
#include <vector>

#include "sim/record/log_detail.h"
#include "sim/record/run_summary.h"
#include "sim/record/tick_times.h"
#include "sim/scenario/scenario.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

/// Percentiles are the smallest sample that at least that share of the samples does not exceed.
StageTimes StageTimesOf(std::vector<double> times_ms, double deadline_ms);

/// Versions of this program and of what it is built on, {name, version}; "sidestep" comes first.
std::vector<std::pair<std::string, std::string>> Versions();

/// What the summary tells beside the outcome.
struct RunFacts {
  std::vector<std::string> command;
  std::vector<StageTime> solves;      ///< One a solve of the MPC.
  std::vector<StageTime> whole_body;  ///< One a run of the whole-body control.
  double simulated_s{0.0};
  RunTime took;
  LogDetail log{LogDetail::kFull};
};

/// The summary of a run of `scenario`.
RunSummary MakeSummary(const Scenario& scenario, const RunOutcome& outcome, const RunFacts& facts);

}  // namespace sidestep
