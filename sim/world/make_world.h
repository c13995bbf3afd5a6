// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// make_world: the plants of a scenario. Here alone a plant's parts are picked out of it.

#include <memory>

#include "sim/world/world.h"

namespace sidestep {

struct Scenario;
class MujocoWorld;
class CentroidalWorld;

/// Makes the plant that the scenario asks for. Throws ConfigError as its constructor does.
std::unique_ptr<World> MakeWorld(const Scenario& scenario);

/// The plant `mujoco` of a scenario, whatever its key `plant` says.
MujocoWorld MakeMujocoWorld(const Scenario& scenario);

/// The plant `centroidal` of a scenario, its feet as far apart as the first gait's.
CentroidalWorld MakeCentroidalWorld(const Scenario& scenario);

}  // namespace sidestep
