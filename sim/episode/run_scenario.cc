// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/run_scenario.h"

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
  const ClockReading start = ClockReading::Now();
  Episode episode = StartEpisode(scenario, make_controller);
  Recorder recorder(scenario, *episode.world, options.out_dir, options.command, options.log);
  ProblemDump dump(options.out_dir, options.dump_every_problem);
  const auto finish = [&] {
    const StageTime whole = ClockReading::Now().Since(start);
    const RunTime took{1e-3 * whole.wall_ms, 1e-3 * whole.cpu_ms};
    const RunOutcome outcome = episode.judge.Conclude();
    const RunResult result{outcome.verdict, options.out_dir, episode.time_s(), took};
    if (options.on_verdict) options.on_verdict(result);
    recorder.Finish(outcome, episode.time_s(), took);
    return result;
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
