// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/run_scenario.h"

#include <chrono>
#include <memory>

#include "sim/world/make_world.h"

namespace sidestep {

RunResult RunScenario(const Scenario& scenario, const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::unique_ptr<World> world = MakeWorld(scenario);
  Judge judge(scenario, world->mass_kg(), world->joints());
  Recorder recorder(scenario, *world, options.out_dir, options.command);
  ProblemDump dump(options.out_dir, options.dump_every_problem);
  const double simulated_s =
      RunEpisode(scenario, world.get(), &judge, &recorder, &dump, options.progress);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const RunOutcome outcome = judge.Conclude();
  recorder.Finish(outcome, simulated_s, wall.count());
  return {outcome.verdict, options.out_dir};
}

}  // namespace sidestep
