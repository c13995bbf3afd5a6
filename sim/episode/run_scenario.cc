// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/run_scenario.h"

#include <chrono>

namespace sidestep {

RunResult RunScenario(const Scenario& scenario, const RunOptions& options,
                      const ControllerFactory& make_controller) {
  const auto start = std::chrono::steady_clock::now();
  Episode episode = StartEpisode(scenario, make_controller);
  Recorder recorder(scenario, *episode.world, options.out_dir, options.command);
  ProblemDump dump(options.out_dir, options.dump_every_problem);
  RunEpisode(&episode, {&recorder, &dump, options.progress});
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const RunOutcome outcome = episode.judge.Conclude();
  recorder.Finish(outcome, episode.time_s(), wall.count());
  return {outcome.verdict, options.out_dir};
}

}  // namespace sidestep
