// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// leg_root: the body from which a robot's legs branch off. It need not be the base: a model may be
// rooted above the waist.

#include <mujoco/mujoco.h>

#include <span>

namespace sidestep {

/// Whether `body` is `ancestor` or hangs on it, over any number of bodies.
bool IsAtOrBelow(const mjModel& model, int body, int ancestor);

/// The lowest body at or below `base` that all feet hang on; the base where there is one foot.
/// @param foot_sites  Sites at or below the base, at least one.
int RootOfLegs(const mjModel& model, std::span<const int> foot_sites, int base);

}  // namespace sidestep
