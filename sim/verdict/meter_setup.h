// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// meter_setup: all of a scenario that a run is measured by, beside the plant's own facts.

#include <vector>

#include "models/robot_description/robot_description.h"
#include "sim/scenario/nominal_motion.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

/// Nothing else of a scenario decides a metric: of the controller's settings only the gait's
/// sway (see AskedGait) and how often it is asked.
struct MeterSetup {
  RobotDescription robot;  ///< The nominal one: feet, heights, attitude at the start.
  Plant plant{Plant::kMujoco};
  AskedGait gait;  ///< With the run's duration and the length of a tick.
  VerdictParams bounds;
  std::vector<Push> pushes;
  std::vector<GroundPatch> ground;  ///< Of the world: heights count from it.
  double control_rate_hz{500.0};    ///< The path is sampled as often.
  double plan_friction{0.0};        ///< Of MpcParams: for the controller's own metrics alone.
  double mass_kg{0.0};              ///< Of the plant, > 0.
  std::vector<JointInfo> joints;    ///< Of the plant.
};

/// The setup of a run of `scenario` on a plant of this mass and these joints.
MeterSetup MeterSetupOf(const Scenario& scenario, double mass_kg,
                        const std::vector<JointInfo>& joints = {});

}  // namespace sidestep
