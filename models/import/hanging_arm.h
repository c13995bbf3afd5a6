// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// hanging_arm: joint positions of an arm that hangs down beside the body.

#include "models/import/body_plan.h"
#include "models/import/posture.h"

namespace sidestep::importer {

/// Moves the arm's joints within their ranges: its links as low as they go, but for a spread of
/// `spread_rad` outwards from the shoulder, and joints no farther from zero than that needs.
/// The robot's attitude in `posture` is the one that counts.
void HangArm(const SourceRobot& robot, const Limb& arm, double spread_rad, Posture* posture);

}  // namespace sidestep::importer
