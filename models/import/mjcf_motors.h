// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_motors: torque limits and servos of joints, from a compiled MJCF's actuators.

#include <mujoco/mujoco.h>

#include "models/import/mjcf_bodies.h"

namespace sidestep::importer {

/// Fills the joints' efforts (0 where nothing bounds them), servo stiffness and damping. A joint is
/// bounded by JointEffortLimit_Nm() of its actuators together and by its actuatorfrcrange.
/// @param model  Whose joints' `user` numbers are as mjcf_newer.h says, and those of servos.
void TakeMotors(const mjModel& model, MjcfBodies* bodies, Notes* notes);

}  // namespace sidestep::importer
