// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// resolve_pushes: pushes as forces in newtons at times in seconds, however the file tells them.
//
//   magnitude_mg    F = value * m * 9.81 m/s^2
//   impulse_Nspkg   F = value * m / T, for a half sine pi/2 times that: its mean is 2/pi of its
//   peak at_phase        a tick of the scenario's nominal gait (nominal_motion.h)
// with m the plant's mass, world.mass_scale in it, and T the push's duration_s.

#include <optional>
#include <vector>

#include "models/support/config_tree.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// The pushes of `scenario`, of which all but the pushes is read and CheckMotion() holds.
/// @param root  The tree it was read from, for the places of errors.
/// @throws ConfigError if the gait has no such stride before the run ends, or no such foot.
std::vector<Push> ResolvePushes(const std::vector<PushEntry>& entries, const Scenario& scenario,
                                const ConfigTree& root);

/// Where an instant is in the stride of the first foot that the scenario's gait asks for, from its
/// lift-off (0) to the next (1); empty where there is no whole stride.
std::optional<double> PhaseAt(const Scenario& scenario, double time_s);

}  // namespace sidestep
