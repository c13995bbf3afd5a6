// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_geometry: what the gait must know of a robot, taken from its description.
//
// Planner and verdict ask here, so that both lay the same gait out.

#include "controller/planner/gait_setup.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Of `robot`, which has feet (ContractViolation). `sway` is PlannerParams::sway; the boxes are
/// empty: who adjusts steps fills them.
GaitGeometry MakeGaitGeometry(const RobotDescription& robot, const ComSway& sway);

}  // namespace sidestep
