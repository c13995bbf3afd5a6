// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/sagittal_plane.h"

#include <gtest/gtest.h>

#include "tests/support/crooked_robot.h"
#include "tests/support/planar_robot.h"

namespace sidestep::sagittal_plane_test {
namespace {

constexpr double kRounding = 1e-12;

RobotDescription Shipped(const std::string& name) {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models" / name /
                              "robot.yaml");
}

std::string ErrorOfEdit(const std::string& from, const std::string& to) {
  const TempFolder folder;
  RobotDescription robot = UnfoldedPlanarRobot(folder, Edit(kPlanarMjcf, from, to));
  return folder.ErrorOf([&] { FindSagittalPlane(&robot); });
}

TEST(SagittalPlaneTest, FeetOfAPlanarRobotAreBesideItsPlane) {
  const TempFolder folder;
  const RobotDescription robot = PlanarRobot(folder);
  EXPECT_EQ(robot.base_freedom, BaseFreedom::kSagittal);
  EXPECT_NEAR(robot.feet[0].lateral_m, 0.07, kRounding);
  EXPECT_NEAR(robot.feet[1].lateral_m, -0.07, kRounding);
}

TEST(SagittalPlaneTest, AFreeRobotHasNone) {
  const TempFolder folder;
  RobotDescription robot = CrookedRobot(folder);
  FindSagittalPlane(&robot);
  EXPECT_EQ(robot.base_freedom, BaseFreedom::kFree);
  EXPECT_EQ(robot.feet[0].lateral_m, 0.0);
  robot.feet[0].vertices_m = Eigen::Matrix3Xd::Identity(3, 3);
  EXPECT_EQ(InItsPlane(robot).feet[0].vertices_m, robot.feet[0].vertices_m);
}

TEST(SagittalPlaneTest, JointsFeetAndComMustSuitThePlane) {
  const std::string start = "planar.xml: error: of a base that moves in a plane ";
  EXPECT_EQ(ErrorOfEdit("name=\"knee_l\" type=\"hinge\" axis=\"0 1 0\"",
                        "name=\"knee_l\" type=\"hinge\" axis=\"0.1 1 0\""),
            start + "joint 'knee_l' must turn about y or slide along x and z");
  EXPECT_EQ(ErrorOfEdit("axis=\"0.1 0 -1\"", "axis=\"0.1 0.1 -1\""),
            start + "joint 'slide_r' must turn about y or slide along x and z");
  EXPECT_EQ(ErrorOfEdit("name=\"left_sole\" pos=\"0.01 0 -0.2\" euler=\"0 0.2 0\"",
                        "name=\"left_sole\" pos=\"0.01 0 -0.2\" euler=\"0.1 0.2 0\""),
            start + "frame 'left_sole' must have its y axis along the world's");
  EXPECT_EQ(ErrorOfEdit("name=\"left_sole\" pos=\"0.01 0 -0.2\"",
                        "name=\"left_sole\" pos=\"0.01 0.01 -0.2\""),
            start + "the feet must be as far to the left, the first one's side, as to the right");
  EXPECT_EQ(ErrorOfEdit("pos=\"0.03 -0.007 0.05\"", "pos=\"0.03 0.008 0.05\""),
            start + "the CoM must be at y = 0, not at 0.01 m");
}

TEST(SagittalPlaneTest, TheFirstFootIsTheLeftOne) {
  const TempFolder folder;
  RobotDescription robot = UnfoldedPlanarRobot(folder, kPlanarMjcf);
  std::swap(robot.feet[0], robot.feet[1]);
  EXPECT_EQ(folder.ErrorOf([&] { FindSagittalPlane(&robot); }),
            "planar.xml: error: of a base that moves in a plane the feet must be as far to the "
            "left, the first one's side, as to the right");
}

TEST(SagittalPlaneTest, WhatIsWrongWithTheFeetIsSaidAtTheirPlace) {
  const TempFolder folder;
  const ConfigTree root = ReadConfigFile(folder.Write("robot.yaml", "a: 1\nfeet: [left]\n"));
  ConfigMap map(root, "");
  const ConfigNode feet = map.Required("feet");
  RobotDescription robot = UnfoldedPlanarRobot(folder, kPlanarMjcf);
  std::swap(robot.feet[0], robot.feet[1]);
  EXPECT_EQ(folder.ErrorOf([&] { FindSagittalPlane(&robot, &feet); }),
            "robot.yaml:2:7: error: feet of a base that moves in a plane: the feet must be as far "
            "to the left, the first one's side, as to the right");
}

TEST(SagittalPlaneTest, CornersSideBySideBecomeOneVertexInThePlane) {
  const RobotDescription biped = InItsPlane(Shipped("biped"));
  for (const FootDescription& foot : biped.feet) {
    ASSERT_EQ(foot.vertices_m.cols(), 2) << foot.name;
    EXPECT_EQ(foot.vertices_m.row(0), Eigen::RowVector2d(0.095, -0.095));
    EXPECT_LT((foot.vertices_m.row(1).array() + foot.lateral_m).matrix().norm(), kRounding);
    EXPECT_EQ(foot.vertices_m.row(2), Eigen::RowVector2d::Zero());
    EXPECT_EQ(foot.force_shares.size(), 0) << "equal shares stay equal";
  }
  EXPECT_NEAR(biped.feet[0].lateral_m, 0.06, kRounding);
}

TEST(SagittalPlaneTest, PointFeetComeIntoThePlane) {
  const RobotDescription rabbit = InItsPlane(Shipped("rabbit"));
  EXPECT_LT((rabbit.feet[0].vertices_m - Eigen::Vector3d(0, -0.06, 0)).norm(), kRounding);
  EXPECT_LT((rabbit.feet[1].vertices_m - Eigen::Vector3d(0, 0.06, 0)).norm(), kRounding);
}

TEST(SagittalPlaneTest, AVertexTakesTheSharesOfItsCorners) {
  RobotDescription robot = Shipped("biped");
  FootDescription& foot = robot.feet[0];
  foot.force_shares = Eigen::Vector4d(0.1, 0.2, 0.3, 0.4);
  // By hand: the front corners are the first two, the back ones the others.
  EXPECT_LT((InItsPlane(robot).feet[0].force_shares - Eigen::Vector2d(0.3, 0.7)).norm(), kRounding);
  foot.vertices_m = Eigen::Matrix3Xd(3, 3);
  foot.vertices_m << 0.1, -0.1, -0.1, 0.0, 0.04, -0.04, 0.0, 0.0, 0.0;
  foot.force_shares.resize(0);
  const FootDescription seen = InItsPlane(robot).feet[0];
  EXPECT_LT((seen.force_shares - Eigen::Vector2d(1.0 / 3.0, 2.0 / 3.0)).norm(), kRounding)
      << "one corner in front of two: the mean of the corners stays preferred";
}

}  // namespace
}  // namespace sidestep::sagittal_plane_test
