// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// upper_body: which joints and links are arms and torso, once the legs are known.

#include "models/import/body_plan.h"

namespace sidestep::importer {

/// Finds arms, torso and the joints between it and the legs. Arms are the heaviest two branches
/// that mirror each other to the left and the right of the legs.
/// @param plan  With its legs, pelvis and facing.
void FindUpperBody(const SourceRobot& robot, BodyPlan* plan);

}  // namespace sidestep::importer
