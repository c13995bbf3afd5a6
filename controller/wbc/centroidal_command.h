// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_command: the last stage where the plant has no body: forces are the command.

#include <vector>

#include "controller/types/actuator_command.h"
#include "controller/types/control_tick.h"

namespace sidestep::wbc {

/// Hands the MPC's vertex forces and the feet's places to the centroidal plant. Does not allocate
/// after the first call with that many feet and vertices.
void WriteCentroidalCommand(const std::vector<FootTarget>& feet, ActuatorCommand* command);

}  // namespace sidestep::wbc
