// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// hopping_pendulum: the largest push that a hopper on one point foot survives.
//
// In stance the ground bears the weight of stance and flight, so that the CoM's way x from the foot
// grows as x'' = omega^2 x with omega^2 = (g / h) (stance + flight) / stance; in flight its speed
// is constant while the foot moves below it. With c, s the cosh and sinh of omega times the stance,
// a foot set p ahead of a CoM of speed v has it leave x = v s / omega - p c ahead of the foot, at
// v c - p omega s. The farther ahead the better, both for the speed that is left and for where the
// foot is then: so the foot goes as far as reach and its own speed let it, until the CoM would turn
// back. If nothing but the reach R bounds it, a speed is caught up to omega R coth(omega stance /
// 2).

#include "sim/limit/limit_params.h"

namespace sidestep::limit {

/// The largest step of velocity (m/s) of a hop in place, `time_s` after touch-down (within stance
/// and flight), that is survived. To no accuracy better than 1e-6 m/s.
double HopLimit(const LimitParams& params, double time_s);

}  // namespace sidestep::limit
