// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/make_world.h"

#include "sim/scenario/scenario.h"
#include "sim/world/centroidal_world.h"
#include "sim/world/mujoco_world.h"

namespace sidestep {

MujocoWorld MakeMujocoWorld(const Scenario& scenario) {
  return MujocoWorld(scenario.robot, scenario.world, scenario.pushes);
}

CentroidalWorld MakeCentroidalWorld(const Scenario& scenario) {
  const double start_width_m = scenario.gait.empty() ? 0.0 : scenario.gait.front().step_width_m;
  return CentroidalWorld(scenario.robot, start_width_m, scenario.world, scenario.pushes);
}

std::unique_ptr<World> MakeWorld(const Scenario& scenario) {
  if (scenario.plant == Plant::kCentroidal) {
    return std::make_unique<CentroidalWorld>(MakeCentroidalWorld(scenario));
  }
  return std::make_unique<MujocoWorld>(MakeMujocoWorld(scenario));
}

}  // namespace sidestep
