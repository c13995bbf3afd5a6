// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/raise_base.h"

#include "models/import/posture.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

Notes Raise(SourceRobot* robot) {
  Notes notes;
  RaiseBase(FindBodyPlan(*robot, "robot.urdf", &notes), robot, &notes);
  return notes;
}

TEST(RaiseBase, ABaseDrawnFromTheFloorGetsItsFrameAtItsCom) {
  MakerRobot maker;
  maker.is_drawn_from_floor = true;
  SourceRobot robot = SourceOf(maker);
  const Placement before(robot, ZeroPosture(robot));
  const Notes notes = Raise(&robot);
  EXPECT_TRUE(HasNote(notes, "moved the frame of the base 'pelvis' to its CoM, 0.87 m up"));
  EXPECT_TRUE(LinkCalled(robot, "pelvis").mass.com_m.isZero());
  const Placement after(robot, ZeroPosture(robot));
  const Eigen::Vector3d moved = before.com_W() - after.com_W();
  EXPECT_NEAR((moved - Eigen::Vector3d(0.0, 0.0, 0.87)).norm(), 0.0, 1e-12);
  for (const char* name : {"left_foot", "right_forearm", "head"}) {
    const int link = FindLink(robot, name);
    EXPECT_NEAR((before.X_WL(link).translation() - after.X_WL(link).translation() - moved).norm(),
                0.0, 1e-12)
        << name;
  }
  const SourceLink& pelvis = LinkCalled(robot, "pelvis");
  EXPECT_TRUE(pelvis.collisions[0].X_LS.translation().isZero(1e-12)) << "a box around the CoM";
  EXPECT_TRUE(pelvis.visuals[0].X_LS.translation().isZero(1e-12));
}

TEST(RaiseBase, ABaseAtTheHipsIsLeftAlone) {
  SourceRobot robot = SourceOf(MakerRobot());
  EXPECT_FALSE(HasNote(Raise(&robot), "moved"));
  EXPECT_EQ(LinkCalled(robot, "pelvis").mass.com_m.z(), 0.02);
}

}  // namespace
}  // namespace sidestep::importer
