// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_motors: torque limits and servos of joints, from a compiled MJCF's actuators.

#include <mujoco/mujoco.h>

#include "models/import/mjcf_bodies.h"

namespace sidestep::importer {

/// Fills the joints' efforts (0 where nothing bounds them), servo stiffness and damping. A motor is
/// bounded by its ctrlrange and forcerange, a servo by its forcerange, either by its joint's
/// actuatorfrcrange, all through the gear; where the two ends differ, the nearer counts. A servo is
/// a <position>, or a <general> whose bias is -gain times the position.
/// @param model  Whose joints' `user` numbers are as mjcf_newer.h says, and those of <position>s.
void TakeMotors(const mjModel& model, MjcfBodies* bodies, Notes* notes);

}  // namespace sidestep::importer
