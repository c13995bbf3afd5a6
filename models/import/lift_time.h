// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// lift_time: how quickly the knees' motors can lift a foot.

#include "models/import/body_plan.h"
#include "models/import/source_robot.h"
#include "models/import/start_pose.h"

namespace sidestep::importer {

/// The least time (s) of a swing that lifts the foot by `height_m` and lowers it again with the
/// torque that the weaker knee has for its rotor and its damping as the source tells them: of a
/// small servo with a gear of several hundred to one that is more than a pendulum's fall allows. 0
/// where the source tells neither.
double LeastLiftTime_s(const SourceRobot& robot, const BodyPlan& plan, const StartPose& start,
                       double height_m);

}  // namespace sidestep::importer
