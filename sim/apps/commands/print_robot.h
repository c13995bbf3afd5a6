// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// print_robot: what `sidestep robots NAME` tells of a robot in numbers.

#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Prints mass, CoM, soles, legs and servos with their margins; warnings go to the standard error.
/// Nothing of a robot without a model.
void PrintRobotFigures(const RobotDescription& robot);

}  // namespace sidestep
