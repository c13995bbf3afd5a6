// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/shared_prefix.h"

#include <algorithm>

#include "sim/scenario/push_ticks.h"
#include "sim/scenario/write_scenario.h"

namespace sidestep {

Scenario WithoutWords(Scenario scenario) {
  scenario.name = "cell";
  scenario.description.clear();
  scenario.expect.clear();
  scenario.video = {};
  return scenario;
}

std::string PrefixText(const Scenario& scenario) {
  Scenario bare = WithoutWords(scenario);
  for (Push& push : bare.pushes) {
    const std::string body = push.body;
    push = Push();
    push.body = body;
    push.duration_s = scenario.world.step_s;
  }
  return ResolvedYaml(bare);
}

Tick FirstPushTick(const Scenario& scenario) {
  Tick first = -1;
  for (const Push& push : scenario.pushes) {
    const Tick start = TicksOf(push, scenario.world.step_s).first;
    first = first < 0 ? start : std::min(first, start);
  }
  return first;
}

}  // namespace sidestep
