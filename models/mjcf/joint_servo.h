// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// joint_servo: what of a compiled MJCF's actuators is a servo of a joint, and how hard one pulls.

#include <mujoco/mujoco.h>

namespace sidestep {

/// Whether the actuator holds its joint where its control, or what it makes of that, is: a
/// <position> or <intvelocity>, or a <general> whose bias is -gain times the position.
bool IsJointServo(const mjModel& model, int actuator);

/// Nm or N at the joint, both ways: a motor's by its ctrlrange and forcerange, any other's by its
/// forcerange, through the gear. Where the two ends differ, the nearer counts; of a range that
/// begins at zero, its other end. Infinite where nothing bounds it.
double JointEffortLimit_Nm(const mjModel& model, int actuator);

/// What of a range holds both ways, as above.
double RangeBound(const mjtNum* range);

}  // namespace sidestep
