// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// summary: the text of summary.json, what a run amounts to.

#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

/// Wall-clock figures of the MPC's solves (ms). NaN without a solve.
struct SolveTimes {
  double p50_ms;
  double p99_ms;
  double max_ms;
  int misses;  ///< Solves that took longer than the deadline.
  int count;
};

/// Percentiles are the smallest sample that at least that share of the samples does not exceed.
SolveTimes SummariseSolveTimes(std::vector<double> solve_ms, double deadline_ms);

/// Versions of this program and of what it is built on, {name, version}.
std::vector<std::pair<std::string, std::string>> Versions();

/// What the summary tells beside the outcome.
struct RunFacts {
  std::vector<std::string> command;
  std::vector<double> solve_ms;  ///< One a solve.
  double simulated_s{0.0};
  double wall_s{0.0};
};

/// JSON, indented, with a final newline; null for what is not finite.
std::string SummaryJson(const Scenario& scenario, const RunOutcome& outcome, const RunFacts& facts);

}  // namespace sidestep
