// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/write_urdf.h"

#include "models/import/posture.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

TEST(WriteUrdf, ReadsBackAsTheSameRobot) {
  MakerRobot maker;
  maker.foot = MakerFoot::kSpheres;
  SourceRobot robot = SourceOf(maker);
  robot.joints[3].X_PC.linear() =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  robot.joints[4].X_PC.linear() =
      Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const SourceRobot again = SourceOf(UrdfText(robot, "a--b.urdf"));
  ASSERT_EQ(again.links.size(), robot.links.size());
  EXPECT_NEAR(TotalMass_kg(again), TotalMass_kg(robot), 1e-8);
  const Placement here(robot, ZeroPosture(robot)), there(again, ZeroPosture(again));
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const int link = FindLink(again, robot.links[i].name);
    ASSERT_GE(link, 0);
    EXPECT_TRUE(here.X_WL(static_cast<int>(i)).isApprox(there.X_WL(link), 1e-8))
        << robot.links[i].name;
    const SourceLink& other = again.links[static_cast<std::size_t>(link)];
    EXPECT_TRUE(other.mass.inertia_kgm2.isApprox(robot.links[i].mass.inertia_kgm2, 1e-8));
    EXPECT_EQ(other.collisions.size(), robot.links[i].collisions.size());
    EXPECT_EQ(other.visuals.size(), robot.links[i].visuals.size());
  }
}

TEST(WriteUrdf, ACommentCannotEndEarly) {
  SourceRobot robot = SourceOf(MakerRobot());
  robot.links[0].note = "tricky --> <link name=\"evil\"/>";
  EXPECT_EQ(FindLink(SourceOf(UrdfText(robot, "x")), "evil"), -1);
}

}  // namespace
}  // namespace sidestep::importer
