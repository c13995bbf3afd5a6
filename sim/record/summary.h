// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// summary: the text of summary.json, what a run amounts to.

#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

/// Wall-clock figures of a stage's runs (ms). NaN without a run.
struct StageTimes {
  double mean_ms;
  double p50_ms;
  double p99_ms;
  double max_ms;
  int misses;  ///< Runs that took longer than the deadline.
  int count;
};

/// Percentiles are the smallest sample that at least that share of the samples does not exceed.
StageTimes Summarise(std::vector<double> times_ms, double deadline_ms);

/// Versions of this program and of what it is built on, {name, version}.
std::vector<std::pair<std::string, std::string>> Versions();

/// What the summary tells beside the outcome.
struct RunFacts {
  std::vector<std::string> command;
  std::vector<double> solve_ms;       ///< One a solve of the MPC.
  std::vector<double> whole_body_ms;  ///< One a run of the whole-body control.
  double simulated_s{0.0};
  double wall_s{0.0};
};

/// JSON, indented, with a final newline; null for what is not finite.
std::string SummaryJson(const Scenario& scenario, const RunOutcome& outcome, const RunFacts& facts);

}  // namespace sidestep
