// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_geometry: what the gait must know of a robot, taken from its description.
//
// Planner and verdict ask here, so that both lay the same gait out.

#include "controller/planner/gait_setup.h"
#include "controller/types/gait_params.h"
#include "controller/types/mpc_params.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Of `robot`, which has feet (ContractViolation), with the sway of `planner` and the boxes of
/// `mpc`.
GaitGeometry MakeGaitGeometry(const RobotDescription& robot, const PlannerParams& planner,
                              const MpcParams& mpc);

}  // namespace sidestep
