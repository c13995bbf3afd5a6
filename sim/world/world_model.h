// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// world_model: the mjModel of a world: robot, floor, light and sky.

#include <string>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"
#include "sim/scenario/world_params.h"

namespace sidestep {

struct Scenario;

/// Compiles a robot's MJCF on a floor with the friction, physics step and mass_scale of `params`.
/// Joints and qpos are the same at either detail.
/// Throws ConfigError with MuJoCo's message if the MJCF does not compile, or if there is none.
MjModelPtr CompileRobotWorld(const RobotDescription& robot, const WorldParams& params,
                             ModelDetail detail);

/// For the centroidal plant, which has no bodies, a stand-in to draw: a ball `com` and one body per
/// foot, each with a free joint, so that qpos is what a recording holds.
MjModelPtr CompileCentroidalStandIn(const RobotDescription& robot, const WorldParams& params);

/// The world of a scenario with only defaults, as one MJCF document that MuJoCo by itself loads as
/// the same model, number for number: the robot with what is only drawn, floor and light; or the
/// stand-in of a robot without a model.
/// Throws ConfigError and ContractViolation where its model is none.
std::string DrawnWorldMjcf(const RobotDescription& robot);

/// The text that MuJoCo compiles to simulate `scenario`: the world's MJCF, then the robot's that it
/// includes. `world.friction` and `mass_scale` are set afterwards. Only of the plant mujoco.
std::string SimulatedMjcf(const Scenario& scenario);

/// What a recording of `scenario` is drawn with: the one or the other, by its plant.
MjModelPtr CompileDrawnWorld(const Scenario& scenario);

}  // namespace sidestep
