// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/lift_time.h"

#include <cmath>

#include "models/import/posture.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

constexpr double kLift_m = 0.03;

/// A robot whose thighs and shanks are 0.35 m long, on legs at 93 % of that, its knees' motors as
/// given.
double LiftTime_s(double armature_kgm2, double damping_Nms_per_rad) {
  SourceRobot robot = SourceOf(MakerRobot());
  Notes notes;
  const BodyPlan plan = FindBodyPlan(robot, "robot.urdf", &notes);
  for (const char* knee : {"left_knee", "right_knee"}) {
    SourceJoint& joint = robot.joints[static_cast<std::size_t>(JointCalled(robot, knee))];
    joint.armature_kgm2 = armature_kgm2;
    joint.damping_Nms_per_rad = damping_Nms_per_rad;
    joint.effort_Nm = 100.0;
  }
  StartPose start;
  start.posture = ZeroPosture(robot);
  for (const char* knee : {"left_knee", "right_knee"})
    start.posture.q[JointCalled(robot, knee)] = 2.0 * std::acos(0.93);
  return LeastLiftTime_s(robot, plan, start, kLift_m);
}

// The distance from hip to ankle is 0.7 m cos(q / 2): 0.35 m sin(q / 2) a radian.
const double kTurn_rad = kLift_m / (0.35 * std::sqrt(1.0 - 0.93 * 0.93));

TEST(LiftTime, IsTheOneWithWhichTheRotorTakesTheWholeTorque) {
  const double time_s = LiftTime_s(2.0, 0.0);
  EXPECT_NEAR(2.0 * 5.774 * kTurn_rad / (0.25 * time_s * time_s), 100.0, 1e-6);
}

TEST(LiftTime, IsTheOneWithWhichDampingTakesTheWholeTorque) {
  EXPECT_NEAR(30.0 * 1.875 * kTurn_rad / (0.5 * LiftTime_s(0.0, 30.0)), 100.0, 1e-6);
}

TEST(LiftTime, GrowsWithEither) {
  EXPECT_EQ(LiftTime_s(0.0, 0.0), 0.0);
  EXPECT_GT(LiftTime_s(2.0, 30.0), LiftTime_s(2.0, 0.0));
  EXPECT_GT(LiftTime_s(2.0, 30.0), LiftTime_s(0.0, 30.0));
}

}  // namespace
}  // namespace sidestep::importer
