// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/weak_legs.h"

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// Of the maker's robot at zero, with another effort of the left hip's roll.
Notes NotesWith(SourceRobot robot, double effort_Nm) {
  Notes ignored;
  const BodyPlan plan = FindBodyPlan(robot, "robot.urdf", &ignored);
  robot.joints[static_cast<std::size_t>(JointCalled(robot, "left_hip_roll"))].effort_Nm = effort_Nm;
  return WeakLegs(robot, plan, ZeroPosture(robot));
}

TEST(WeakLegs, TheHipsRollCarriesAllButTheLegBesideIt) {
  const SourceRobot robot = SourceOf(MakerRobot());
  const Placement zero(robot, ZeroPosture(robot));
  const int roll = JointCalled(robot, "left_hip_roll");
  const int leg = robot.joints[static_cast<std::size_t>(roll)].child;
  // The rest hangs beside the hip: its weight times how far to the right its CoM is.
  const double rest_kg = TotalMass_kg(robot) - SubtreeMass_kg(robot, leg);
  const Eigen::Vector3d rest_m =
      (TotalMass_kg(robot) * zero.com_W() - SubtreeMass_kg(robot, leg) * zero.CenterOfMass_W(leg)) /
      rest_kg;
  const double needed_Nm = 9.81 * rest_kg * (zero.X_WJ(roll).translation().y() - rest_m.y());
  ASSERT_GT(needed_Nm, 1.0);
  EXPECT_TRUE(NotesWith(robot, 1.001 * needed_Nm).empty());
  const Notes notes = NotesWith(robot, 0.999 * needed_Nm);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].find("'left_hip_roll' has "), 0U) << notes[0];
}

}  // namespace
}  // namespace sidestep::importer
