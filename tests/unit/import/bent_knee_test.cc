// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/bent_knee.h"

#include <cmath>

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

TEST(BentKnee, BendsByTheAngleOfTwoEqualLinks) {
  const SourceRobot robot = SourceOf(MakerRobot());
  Notes notes;
  const BodyPlan plan = FindBodyPlan(robot, "robot.urdf", &notes);
  Posture posture = ZeroPosture(robot);
  const double length_m = BendKnee(robot, plan.legs[0], plan.legs[0].end, 0.9, &posture);
  EXPECT_NEAR(length_m, 0.7, 1e-4);  // its range less its margin begins at 0.03 rad
  const double q = posture.q[JointCalled(robot, "left_knee")];
  EXPECT_NEAR(std::cos(0.5 * q), 0.9, 0.005);
  EXPECT_EQ(posture.q[JointCalled(robot, "left_hip_pitch")], 0.0);
}

}  // namespace
}  // namespace sidestep::importer
