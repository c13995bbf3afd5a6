// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// weak_ankles: whether ankles can use the soles that they stand on.

#include <array>
#include <string>
#include <vector>

#include "models/import/body_plan.h"
#include "models/import/feet.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// A sentence for every joint of the ankles whose effort can't hold the robot's weight over the
/// edge of its sole: m g times half the sole's length or width, as its axis lies. With less, the
/// feet feel smaller than they are.
Notes WeakAnkles(const SourceRobot& robot, const BodyPlan& plan, const std::array<Foot, 2>& feet);

}  // namespace sidestep::importer
