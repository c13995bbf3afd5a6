// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_scenario: a scenario from its data to a verdict and a folder of evidence (but the pictures,
// which are drawn from the folder).

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/episode/run_episode.h"
#include "sim/record/log_detail.h"
#include "sim/scenario/scenario.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

struct RunResult {
  Verdict verdict;
  std::filesystem::path out_dir;
  double simulated_s{0.0};
  RunTime took{};
};

/// Where and how a run is recorded; none of it changes the run.
struct RunOptions {
  std::filesystem::path out_dir;     ///< Created if need be; see Recorder for what it holds.
  std::vector<std::string> command;  ///< The program's arguments, for summary.json.
  bool dump_every_problem{false};    ///< Not only failed MPC problems; see ProblemDump.
  EpisodeProgress progress;          ///< May be empty.
  LogDetail log{LogDetail::kFull};   ///< What is kept of its ticks.
  /// Told once the run is judged, before the last files are written, which may fail. May be empty.
  std::function<void(const RunResult& result)> on_verdict{};
};

/// Runs and judges. Throws ConfigError if a file can't be written or the robot does not compile.
/// However a run ends, its folder is whole: until it is judged, and if an error ends it, its
/// summary says INVALID.
/// @param make_controller  Who controls the robot; by default whom the scenario asks for.
RunResult RunScenario(const Scenario& scenario, const RunOptions& options,
                      const ControllerFactory& make_controller = MakeController);

}  // namespace sidestep
