// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/foot_shape.h"

#include <gtest/gtest.h>

#include "models/mjcf/mjcf.h"
#include "models/support/require.h"

namespace sidestep::foot_shape_test {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(DistanceOutsideTest, IsToTheNearestSideOrCorner) {
  const Points hull{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  EXPECT_EQ(DistanceOutside(hull, {1, 0.5}), 0.0);
  EXPECT_EQ(DistanceOutside(hull, {2, 0.5}), 0.0) << "on the border";
  EXPECT_NEAR(DistanceOutside(hull, {1, -0.3}), 0.3, 1e-15);
  EXPECT_NEAR(DistanceOutside(hull, {5, 5}), 5.0, 1e-15);  // 3 beside and 4 above the corner
  EXPECT_NEAR(DistanceOutside({{1, 1}}, {4, 5}), 5.0, 1e-15);
  EXPECT_NEAR(DistanceOutside({{0, 0}, {2, 0}}, {1, 0.1}), 0.1, 1e-15);
  EXPECT_THROW(DistanceOutside({}, {0, 0}), ContractViolation);
}

/// A foot of these geoms, its sole frame at `site`.
std::optional<FootShape> ShapeOf(const std::string& geoms, const std::string& site) {
  const MjModelPtr model = CompileMjcf(
      "<mujoco><worldbody><body><freejoint/><inertial pos='0 0 0' mass='1' "
      "diaginertia='1 1 1'/>" +
          geoms +
          "<body pos='0 0 0.1'><inertial pos='0 0 0' mass='1' diaginertia='1 1 "
          "1'/><site name='F' " +
          site + "/></body></body></worldbody></mujoco>",
      "", "test");
  const MjDataPtr data = MakeData(*model);
  mj_kinematics(model.get(), data.get());
  return FootShapeOf(*model, *data, 0);
}

TEST(FootShapeTest, OfABoxItIsTheUndersideInTheSolesFrame) {
  const auto shape =
      ShapeOf("<geom type='box' size='0.1 0.05 0.02' pos='0.03 0 0'/>", "pos='0.03 0 -0.12'");
  ASSERT_TRUE(shape);
  EXPECT_NEAR(shape->lowest_z_m, 0.0, 1e-12);
  ASSERT_EQ(shape->hull.size(), 4U);
  EXPECT_LT((shape->hull[2] - Eigen::Vector2d(0.1, 0.05)).norm(), 1e-12);
}

TEST(FootShapeTest, BallsCountWhereTheyTouchAndWhatIsHigherDoesNot) {
  const std::string balls =
      "<geom type='sphere' size='0.01' pos='0.1 0.04 0'/><geom type='sphere' size='0.01' pos='0.1 "
      "-0.04 0'/><geom type='sphere' size='0.01' pos='-0.1 0 0'/>";
  const std::string shin = "<geom type='capsule' size='0.2' fromto='0 0 0.4 0 0 0.8'/>";
  const auto shape = ShapeOf(balls + shin, "pos='0 0 -0.11'");
  ASSERT_TRUE(shape);
  EXPECT_NEAR(shape->lowest_z_m, 0.0, 1e-12);
  EXPECT_EQ(shape->hull.size(), 3U);
  EXPECT_EQ(DistanceOutside(shape->hull, {0.09, 0}), 0.0);
  EXPECT_NEAR(DistanceOutside(shape->hull, {-0.12, 0}), 0.02, 1e-12);
}

TEST(FootShapeTest, LyingCapsulesAndStandingCylindersHaveTheirLength) {
  const auto capsule =
      ShapeOf("<geom type='capsule' size='0.02' fromto='-0.1 0 0 0.1 0 0'/>", "pos='0 0 -0.12'");
  ASSERT_TRUE(capsule);
  EXPECT_NEAR(capsule->lowest_z_m, 0.0, 1e-12);
  ASSERT_EQ(capsule->hull.size(), 2U);
  EXPECT_NEAR((capsule->hull[1] - capsule->hull[0]).norm(), 0.2, 1e-12);
  const auto disc = ShapeOf("<geom type='cylinder' size='0.05 0.01'/>", "pos='0 0 -0.11'");
  ASSERT_TRUE(disc);
  EXPECT_NEAR(disc->lowest_z_m, 0.0, 1e-12);
  EXPECT_EQ(DistanceOutside(disc->hull, {0.0499, 0}), 0.0);
}

TEST(FootShapeTest, WhatTheFloorCantTouchIsNoShape) {
  EXPECT_FALSE(ShapeOf("<geom type='box' size='1 1 1' contype='0' conaffinity='0'/>", ""));
  EXPECT_FALSE(ShapeOf("", ""));
}

}  // namespace
}  // namespace sidestep::foot_shape_test
