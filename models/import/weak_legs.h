// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// weak_legs: whether hips and knees can carry the robot on one leg.

#include <string>

#include "models/import/body_plan.h"
#include "models/import/posture.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// What is told of a joint with less effort than `what` takes of it.
std::string TooWeak(const SourceJoint& joint, const std::string& what, double needed_Nm);

/// A sentence for every joint between hip and ankle whose effort doesn't hold the robot at rest on
/// that leg alone, in the posture of its start, with the ground's force through its CoM. Of the
/// hips it is mostly the roll: the weight times how far the hip is from the middle.
Notes WeakLegs(const SourceRobot& robot, const BodyPlan& plan, const Posture& start);

}  // namespace sidestep::importer
