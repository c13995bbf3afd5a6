// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// world_model: the mjModel of a scenario's world: robot, floor, light and sky.

#include "models/mjcf/mjcf.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// Compiles the world of `scenario`: the robot's MJCF on a floor with the scenario's friction,
/// physics step and mass_scale. For the centroidal plant, which has no bodies, a stand-in to draw:
/// a ball `com` and one body per foot, each with a free joint, so that qpos is what a recording
/// holds. Joints and qpos are the same at either detail.
/// Throws ConfigError with MuJoCo's message if the robot's MJCF does not compile.
MjModelPtr CompileWorld(const Scenario& scenario, ModelDetail detail = ModelDetail::kDrawn);

}  // namespace sidestep
