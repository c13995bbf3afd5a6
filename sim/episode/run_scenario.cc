// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/run_scenario.h"

#include <chrono>
#include <exception>

namespace sidestep {
namespace {

// The folder of a run that an error ends says so, if the disk still takes it.
template <typename Finish>
void KeepWhatCameOfIt(const Finish& finish) {
  try {
    finish();
  } catch (const std::exception&) {  // the first error is the one to tell
  }
}

}  // namespace

RunResult RunScenario(const Scenario& scenario, const RunOptions& options,
                      const ControllerFactory& make_controller) {
  const auto start = std::chrono::steady_clock::now();
  Episode episode = StartEpisode(scenario, make_controller);
  Recorder recorder(scenario, *episode.world, options.out_dir, options.command);
  ProblemDump dump(options.out_dir, options.dump_every_problem);
  const auto finish = [&] {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    const RunOutcome outcome = episode.judge.Conclude();
    recorder.Finish(outcome, episode.time_s(), wall.count());
    return RunResult{outcome.verdict, options.out_dir, episode.time_s(), wall.count()};
  };
  try {
    RunEpisode(&episode, {&recorder, &dump, options.progress});
  } catch (const std::exception& error) {
    episode.judge.Invalidate(reason::kError, error.what(), episode.time_s());
    KeepWhatCameOfIt(finish);
    throw;
  }
  return finish();
}

}  // namespace sidestep
