// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/feet.h"

#include "tests/support/maker_mjcf.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// The left foot of a maker's MJCF, whose site left_sole is at the middle of its sole.
Foot LeftFootOf(SourceRobot* robot, Notes* notes) {
  const TempFolder folder;
  MeshFiles files(folder.path() / "robot.xml", {});
  const BodyPlan plan = FindBodyPlan(*robot, "robot.xml", notes);
  return MakeFeet(plan, "robot.xml", &files, robot, notes)[0];
}

const std::string& FrameOf(const SourceRobot& robot, const Foot& foot) {
  return robot.links[static_cast<std::size_t>(foot.frame)].name;
}

TEST(Feet, AMakersFrameOfTheSoleIsTaken) {
  Notes notes;
  SourceRobot robot = SourceOfMjcf(RobotMjcf(MakerMjcf()));
  const Foot foot = LeftFootOf(&robot, &notes);
  EXPECT_EQ(FrameOf(robot, foot), "left_sole");
  EXPECT_TRUE(HasNote(notes, "took 'left_sole' for the frame of its foot"));
  EXPECT_NEAR(foot.vertices_m.row(0).maxCoeff(), 0.11 - 0.005, 1e-9);
}

TEST(Feet, AFrameThatIsOffGetsAnother) {
  for (const char* instead :
       {"pos=\"0.03 0 -0.06\"", "pos=\"0.13 0 -0.07\"", "pos=\"0.03 0 -0.07\" euler=\"0 0 90\""}) {
    std::string mjcf = RobotMjcf(MakerMjcf());
    const std::string at = "name=\"left_sole\" pos=\"0.03 0 -0.07\"";
    mjcf.replace(mjcf.find(at), at.size(), "name=\"left_sole\" " + std::string(instead));
    Notes notes;
    SourceRobot robot = SourceOfMjcf(mjcf);
    EXPECT_EQ(FrameOf(robot, LeftFootOf(&robot, &notes)), "left_sole_2") << instead;
  }
}

TEST(Feet, CornersAreSeenFromTheMakersFrame) {
  std::string mjcf = RobotMjcf(MakerMjcf());
  const std::string at = "name=\"left_sole\" pos=\"0.03";
  mjcf.replace(mjcf.find(at), at.size(), "name=\"left_sole\" pos=\"0.05");
  Notes notes;
  SourceRobot robot = SourceOfMjcf(mjcf);
  const Foot foot = LeftFootOf(&robot, &notes);
  EXPECT_EQ(FrameOf(robot, foot), "left_sole");
  EXPECT_NEAR(foot.vertices_m.row(0).maxCoeff(), 0.105 - 0.02, 1e-9);
  EXPECT_NEAR(foot.vertices_m.row(0).minCoeff(), -0.105 - 0.02, 1e-9);
}

TEST(Feet, ACapsuleTouchesUnderItsEndsAndNotAtThem) {
  MakerMjcf maker;
  maker.foot = MjcfFoot::kCapsules;
  Notes notes;
  SourceRobot robot = SourceOfMjcf(RobotMjcf(maker));
  const Foot foot = LeftFootOf(&robot, &notes);
  EXPECT_NEAR(foot.sole.length_m, 0.20, 1e-6) << "between the middles of its balls";
  EXPECT_NEAR(foot.sole.width_m, 0.08, 1e-6);
  EXPECT_NEAR(foot.sole.X_FS.translation().z(), -0.07, 1e-6);
}

TEST(Feet, PointsThatMarkASoleBecomeABoxOverThem) {
  MakerRobot maker;
  maker.foot = MakerFoot::kMarks;
  Notes notes;
  SourceRobot robot = SourceOf(maker);
  const Foot foot = LeftFootOf(&robot, &notes);
  EXPECT_NEAR(foot.sole.length_m, 0.21, 1e-9);
  EXPECT_NEAR(foot.sole.width_m, 0.09, 1e-9);
  const std::vector<SourceShape>& shapes = LinkCalled(robot, "left_foot").collisions;
  ASSERT_EQ(shapes.size(), 1U);
  EXPECT_EQ(shapes[0].kind, ShapeKind::kBox);
  EXPECT_NEAR(shapes[0].X_LS.translation().z() - 0.5 * shapes[0].size_m.z(), -0.08, 1e-9);
}

TEST(Feet, AGuessFromATurnedInertiaIsLevelAllTheSame) {
  MakerRobot maker;
  maker.foot = MakerFoot::kNone;
  Notes notes;
  SourceRobot robot = SourceOf(maker);
  for (SourceLink& link : robot.links) {
    link.visuals.clear();
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.6, 0.8, 0.0)).toRotationMatrix();
    link.mass.inertia_kgm2 = R * link.mass.inertia_kgm2 * R.transpose();
  }
  const Foot foot = LeftFootOf(&robot, &notes);
  EXPECT_TRUE(foot.is_guessed);
  EXPECT_NEAR(foot.sole.tilt_rad, 0.0, 1e-6);
  EXPECT_GT(foot.sole.length_m, 0.18);
}

}  // namespace
}  // namespace sidestep::importer
