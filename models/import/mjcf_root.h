// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_root: which of an MJCF's bodies is the robot.

#include <mujoco/mujoco.h>

#include "models/import/problems.h"

namespace sidestep::importer {

/// The heaviest body of the world that carries joints on others, with what it carries; -1 if none
/// does. Notes which bodies of the world are left out.
int RootBody(const mjModel& model, Notes* notes);

}  // namespace sidestep::importer
