// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/clean_up.h"

#include <Eigen/Eigenvalues>

#include "models/import/posture.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

SourceRobot Cleaned(SourceRobot robot, Notes* notes = nullptr) {
  Notes unused;
  Problems problems("robot.urdf");
  CleanUp(&robot, &problems, notes == nullptr ? &unused : notes);
  problems.ThrowIfAny();
  return robot;
}

SourceLink& LinkCalled(SourceRobot& robot, const std::string& name) {
  return robot.links[static_cast<std::size_t>(FindLink(robot, name))];
}

TEST(CleanUp, LeavesAGoodRobotAlone) {
  Notes notes;
  const SourceRobot robot = Cleaned(SourceOf(MakerRobot()), &notes);
  EXPECT_TRUE(notes.empty());
  for (const SourceLink& link : robot.links) EXPECT_TRUE(link.note.empty());
}

TEST(CleanUp, MakesAPointMassOfGramsAndKeepsTheCom) {
  MakerRobot maker;
  maker.has_gram_frames = true;
  SourceRobot before = SourceOf(maker);
  SourceRobot after = Cleaned(before);
  EXPECT_FALSE(LinkCalled(after, "camera").has_mass());
  EXPECT_NEAR(TotalMass_kg(after), TotalMass_kg(before), 1e-12);
  EXPECT_LT((Placement(after, ZeroPosture(after)).com_W() -
             Placement(before, ZeroPosture(before)).com_W())
                .norm(),
            1e-12);
  EXPECT_NEAR(LinkCalled(after, "head").mass.mass_kg, 3.005, 1e-12);
}

TEST(CleanUp, FixesMimicsAndWhatMovesNothing) {
  MakerRobot maker;
  maker.has_fingers = true;
  SourceRobot robot = SourceOf(maker);
  LinkCalled(robot, "left_index").mass = MassProperties();
  robot = Cleaned(robot);
  EXPECT_EQ(robot.joints[static_cast<std::size_t>(JointCalled(robot, "left_thumb_joint"))].kind,
            JointKind::kFixed);
  EXPECT_EQ(robot.joints[static_cast<std::size_t>(JointCalled(robot, "left_index_joint"))].kind,
            JointKind::kFixed);
}

TEST(CleanUp, GivesMassToALinkBetweenJoints) {
  SourceRobot robot = SourceOf(MakerRobot());
  LinkCalled(robot, "left_hip_roll_link").mass = MassProperties();
  Notes notes;
  robot = Cleaned(robot, &notes);
  EXPECT_NEAR(LinkCalled(robot, "left_hip_roll_link").mass.mass_kg, 0.01, 1e-12);
  EXPECT_TRUE(IsPhysical(LinkCalled(robot, "left_hip_roll_link").mass));
  ASSERT_EQ(notes.size(), 1U);
}

TEST(CleanUp, MendsImpossibleInertiasAndTellsTheirNumbers) {
  SourceRobot robot = SourceOf(MakerRobot());
  LinkCalled(robot, "left_thigh").mass.inertia_kgm2 =
      Eigen::Vector3d(0.01, 0.02, 0.05).asDiagonal();
  LinkCalled(robot, "left_shank").mass.inertia_kgm2.setZero();
  Notes notes;
  robot = Cleaned(robot, &notes);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_NE(
      notes[0].find("link 'left_thigh' had principal moments 0.01, 0.02, 0.05 kg m^2 of 4.5 kg"),
      std::string::npos)
      << notes[0];
  EXPECT_TRUE(IsPhysical(LinkCalled(robot, "left_thigh").mass));
  EXPECT_NEAR(LinkCalled(robot, "left_thigh").mass.inertia_kgm2(2, 2), 0.05, 1e-12);
  EXPECT_TRUE(IsPhysical(LinkCalled(robot, "left_shank").mass));
}

TEST(CleanUp, TurnsARootWithoutMassRound) {
  const std::string urdf = UrdfOf(MakerRobot());
  const std::string rooted =
      Edit(urdf, "</robot>", R"(<link name="base_footprint"/><link name="tool"/>
<joint name="up" type="fixed"><parent link="base_footprint"/><child link="pelvis"/><origin xyz="0 0 0.9"/></joint>
<joint name="side" type="fixed"><parent link="base_footprint"/><child link="tool"/></joint></robot>)");
  SourceRobot robot = Cleaned(SourceOf(rooted));
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.root)].name, "pelvis");
  const Placement zero(robot, ZeroPosture(robot));
  EXPECT_NEAR(zero.X_WL(FindLink(robot, "base_footprint")).translation().z(), -0.9, 1e-12);
  EXPECT_NEAR(zero.X_WL(FindLink(robot, "tool")).translation().z(), -0.9, 1e-12);
}

TEST(CleanUp, RefusesARobotWithoutMass) {
  const TempFolder folder;
  EXPECT_EQ(
      folder.ErrorOf([] { Cleaned(SourceOf("<robot name=\"r\"><link name=\"a\"/></robot>")); }),
      "robot.urdf:1:17: error: the root 'a' has no mass, nor has what is fixed to it");
}

}  // namespace
}  // namespace sidestep::importer
