// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// bent_knee: which of a leg's joints is the knee and which way it bends.

#include "models/import/body_plan.h"
#include "models/import/posture.h"

namespace sidestep::importer {

/// The knee is the joint that changes the distance from hip (the first joint) to ankle most over
/// its range. It is bent away from where that distance is the largest: to the side with more room
/// or, if there is much on both, so that the ankle goes backwards. Sets the knee so that the
/// distance is `stretch` of the largest, or as near as its range allows.
/// @param ankle  Link whose origin is the ankle or, of a leg that ends in a point, that point.
/// @return       The largest distance (m).
double BendKnee(const SourceRobot& robot, const Limb& leg, int ankle, double stretch,
                Posture* posture);

}  // namespace sidestep::importer
