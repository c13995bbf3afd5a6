// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// raise_base: a base whose origin is on the floor tells nothing about a fall.

#include "models/import/body_plan.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// CAD programs leave the base's origin where the drawing has its own, often between the feet; a
/// fall is judged by the base's height. Moves the base's frame to its CoM where its origin is lower
/// than half the hips' height over the feet (all joints at zero). Nothing else of the robot moves.
void RaiseBase(const BodyPlan& plan, SourceRobot* robot, Notes* notes);

}  // namespace sidestep::importer
