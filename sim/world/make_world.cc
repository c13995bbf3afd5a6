// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "sim/world/centroidal_world.h"
#include "sim/world/mujoco_world.h"
#include "sim/world/world.h"

namespace sidestep {

std::unique_ptr<World> MakeWorld(const Scenario& scenario) {
  if (scenario.plant == Plant::kCentroidal) return std::make_unique<CentroidalWorld>(scenario);
  return std::make_unique<MujocoWorld>(scenario);
}

}  // namespace sidestep
