// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// resting_point: where a standing foot rests on the ground, and so the point about which it turns.
//
// A sole that tips over its edge or spins on a corner moves everywhere but there:
//   v_F + w_F x p_FP = 0
// P is, with what the foot can tell:
//   a point foot       straight below F: a ball of radius sole_height_m rolls
//   force/torque       the centre of pressure, where the ground's force has no horizontal moment
//   touch alone        the lowest of its vertices by its attitude, blurred: the ground's force on a
//                      level sole may be anywhere, and is taken to be in the middle
// Source for the second: Sardain & Bessonnet, "Forces acting on a biped robot. Center of
// pressure - zero moment point", IEEE Trans. SMC A 34 (2004).

#include <Eigen/Core>

#include "controller/model/rigid_body.h"
#include "controller/types/robot_state.h"

namespace sidestep {

/// p_FP, in W (m), of a foot in contact. Reads `state`'s attitude and, of a foot with force/torque
/// sensors, its wrench about F; a centre of pressure off the sole is brought back to it. Does not
/// allocate.
Eigen::Vector3d RestingPoint(const FootDescription& foot, const FootState& state);

}  // namespace sidestep
