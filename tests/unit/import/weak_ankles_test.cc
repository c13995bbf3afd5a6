// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/weak_ankles.h"

#include "tests/support/maker_mjcf.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// Of the maker's MJCF with another effort of the left ankle's pitch.
Notes NotesWith(double effort_Nm) {
  SourceRobot robot = SourceOfMjcf(RobotMjcf(MakerMjcf()));
  const TempFolder folder;
  MeshFiles files(folder.path() / "robot.xml", {});
  Notes ignored;
  const BodyPlan plan = FindBodyPlan(robot, "robot.xml", &ignored);
  const auto feet = MakeFeet(plan, "robot.xml", &files, &robot, &ignored);
  const auto pitch = static_cast<std::size_t>(JointCalled(robot, "left_ankle_pitch"));
  robot.joints[pitch].effort_Nm = effort_Nm * TotalMass_kg(robot);
  return WeakAnkles(robot, plan, feet);
}

TEST(WeakAnkles, ASolesEdgeIsItsLengthOverTwo) {
  EXPECT_TRUE(NotesWith(9.81 * 0.11 * 1.001).empty());
  const Notes notes = NotesWith(9.81 * 0.11 * 0.999);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].find("'left_ankle_pitch' has "), 0U);
}

}  // namespace
}  // namespace sidestep::importer
