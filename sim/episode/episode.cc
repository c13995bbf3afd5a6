// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/episode.h"

#include "models/support/require.h"
#include "sim/scenario/push_ticks.h"
#include "sim/world/make_world.h"

namespace sidestep {

ControllerSetup SetupOf(const Scenario& scenario) {
  return {scenario.robot, scenario.control, scenario.gait, scenario.plant == Plant::kCentroidal,
          scenario.world.step_s};
}

Episode StartEpisode(const Scenario& scenario, const ControllerFactory& make_controller) {
  std::unique_ptr<World> world = MakeWorld(scenario);
  const double mass_kg = world->mass_kg();
  Judge judge(MeterSetupOf(scenario, mass_kg, world->joints()), scenario.expect);
  auto timer = std::make_unique<ClockStageTimer>();
  std::unique_ptr<Controller> controller = make_controller(SetupOf(scenario), timer.get());
  return {scenario,         std::move(world),      MakeSensorSuite(scenario, mass_kg),
          std::move(timer), std::move(controller), std::move(judge)};
}

Episode Fork(const Episode& episode) {
  auto timer = std::make_unique<ClockStageTimer>();
  std::unique_ptr<Controller> controller = episode.controller->Clone(timer.get());
  return {episode.scenario,      episode.world->Clone(), episode.sensors, std::move(timer),
          std::move(controller), episode.judge,          episode.tick,    episode.is_over};
}

Episode ForkWithPushes(const Episode& episode, const std::vector<Push>& pushes) {
  const double tick_s = episode.scenario.world.step_s;
  for (const std::vector<Push>& some : {episode.scenario.pushes, pushes}) {
    for (const Push& push : some) {
      const Tick start = TicksOf(push, tick_s).first;
      SIDESTEP_REQUIRE(start > episode.tick || episode.tick == 0, start);
    }
  }
  Episode fork = Fork(episode);
  fork.scenario.pushes = pushes;
  fork.world->ReplacePushes(pushes, fork.tick);
  fork.judge.ReplacePushes(pushes);
  return fork;
}

}  // namespace sidestep
