// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/point_feet.h"

#include <cmath>
#include <vector>

#include "models/import/start_pose.h"
#include "tests/support/maker_point_biped.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

struct Biped {
  explicit Biped(PointFoot foot) {
    const std::filesystem::path file = WriteMakerPointBiped({"points", foot}, folder.path());
    MeshFiles meshes(file, {});
    robot = ReadSource(file, &notes);
    plan = FindBodyPlan(robot, "robot.urdf", &notes);
    feet = MakeFeet(plan, "robot.urdf", &meshes, &robot, &notes);
  }

  TempFolder folder;
  Notes notes;
  SourceRobot robot;
  BodyPlan plan;
  std::array<Foot, 2> feet;
};

TEST(FitBall, IsTheSphereThatIsLowest) {
  const Ball ball = FitBall({{{0, 0, 0}, 0.05}, {{0.01, 0.02, -0.2}, 0.03}}, {0, 0, 1});
  EXPECT_EQ(ball.radius_m, 0.03);
  EXPECT_EQ(ball.p_m, Eigen::Vector3d(0.01, 0.02, -0.2));
}

TEST(FitBall, IsAsWideAsTheFootAtItsMiddle) {
  std::vector<SurfacePoint> points{{{0.1, 0.1, 0.4}, 0.0}};  // far above: no part of the end
  for (int i = 0; i < 60; ++i) {
    const double angle = i * 0.1047197551;
    points.push_back({{0.5 + 0.02 * std::sin(angle), 0.3, -0.02 * std::cos(angle)}, 0.0});
  }
  const Ball ball = FitBall(points, {0, 0, 1});
  EXPECT_NEAR(ball.radius_m, 0.02, 1e-4);
  EXPECT_LT((ball.p_m - Eigen::Vector3d(0.5, 0.3, 0.0)).norm(), 2e-4);
}

TEST(PointFeet, ADiscIsABallUnderACapsuleAtTheMakersFrame) {
  const Biped biped(PointFoot::kDiscMesh);
  ASSERT_TRUE(biped.plan.stands_on_points());
  for (std::size_t side = 0; side < 2; ++side) {
    const Foot& foot = biped.feet[side];
    EXPECT_NEAR(foot.ball_radius_m, 0.018, 2e-4);
    EXPECT_EQ(biped.robot.links[static_cast<std::size_t>(foot.frame)].name,
              side == 0 ? "FL_foot" : "FR_foot");
    EXPECT_EQ(foot.vertices_m, Eigen::Matrix3Xd::Zero(3, 1));
  }
  const std::vector<SourceShape>& shapes = LinkCalled(biped.robot, "FL_shin").collisions;
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].kind, ShapeKind::kSphere);
  EXPECT_EQ(shapes[1].kind, ShapeKind::kCylinder);
  EXPECT_TRUE(LinkCalled(biped.robot, "FL_foot").collisions.empty());
}

TEST(PointFeet, AMakersSphereStays) {
  const Biped biped(PointFoot::kSphere);
  EXPECT_EQ(biped.feet[0].ball_radius_m, 0.018);
  EXPECT_EQ(LinkCalled(biped.robot, "FL_foot").collisions.size(), 1u);
}

TEST(PointFeet, RefusesASoleOnThreeJointsAndAFootWithoutAShape) {
  const TempFolder folder;
  EXPECT_EQ(folder.ErrorOf([] { Biped(PointFoot::kFlatBox); }),
            "robot.urdf: error: the left foot 'FL_shin' has a flat sole (120 mm x 60 mm) on a leg "
            "of three joints, which can't keep it level: give it a <collision> sphere, or the leg "
            "its ankle");
  EXPECT_EQ(folder.ErrorOf([] { Biped(PointFoot::kNone); }),
            "robot.urdf: error: the left foot 'FL_shin' has no shape that could be read: give it a "
            "<collision> sphere where it touches the ground (--package NAME=DIR says where meshes "
            "lie)");
}

TEST(PointFeet, StartWithTheirBallsOnTheGroundUnderTheCom) {
  const Biped biped(PointFoot::kDiscMesh);
  StartPoseTask task;
  for (std::size_t side = 0; side < 2; ++side) {
    task.sole_frames[side] = biped.feet[side].frame;
    task.sole_heights_m[side] = biped.feet[side].ball_radius_m;
  }
  const StartPose start = FindStartPose(biped.robot, biped.plan, task);
  ASSERT_TRUE(start.is_found) << start.residual;
  const Placement placement(biped.robot, start.posture);
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Vector3d wanted(0.0, (side == 0 ? 0.5 : -0.5) * start.step_width_m,
                                 biped.feet[side].ball_radius_m);
    EXPECT_LT((placement.X_WL(biped.feet[side].frame).translation() - wanted).norm(), 1e-6);
  }
  EXPECT_LT(placement.com_W().head<2>().norm(), 1e-6);
  EXPECT_NEAR(start.stretch, 0.93, 1e-12);
}

}  // namespace
}  // namespace sidestep::importer
