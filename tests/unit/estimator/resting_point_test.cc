// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/resting_point.h"

#include <gtest/gtest.h>

namespace sidestep::resting_point_test {
namespace {

/// A sole of 0.2 x 0.1 m, 0.02 m below F.
FootDescription Sole(bool feels_moment) {
  FootDescription foot;
  foot.sole_height_m = 0.02;
  foot.vertices_m.resize(3, 4);
  foot.vertices_m << 0.1, 0.1, -0.1, -0.1, 0.05, -0.05, 0.05, -0.05, -0.02, -0.02, -0.02, -0.02;
  if (feels_moment) foot.force_torque = {"ankle"};
  return foot;
}

/// The ground's force `force_N` on a foot of this attitude at the point `p_F`, both in its axes.
FootState PressedAt(const Eigen::Vector3d& p_F, const Eigen::Vector3d& force_F_N,
                    const Eigen::Matrix3d& R_WF = Eigen::Matrix3d::Identity()) {
  FootState state;
  state.R_WF = R_WF;
  state.wrench.force_N = R_WF * force_F_N;
  state.wrench.torque_Nm = R_WF * p_F.cross(force_F_N);
  state.in_contact = true;
  return state;
}

Eigen::Matrix3d About(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

TEST(RestingPointTest, PointFootRestsBelowItsMiddleHoweverItIsTilted) {
  FootDescription foot;
  foot.sole_height_m = 0.015;
  foot.vertices_m = Eigen::Vector3d::Zero();
  const FootState tilted = PressedAt({0.0, 0.0, 0.0}, {5.0, 0.0, 9.0}, About({1, 0, 0}, 0.6));
  EXPECT_EQ(RestingPoint(foot, tilted), Eigen::Vector3d(0.0, 0.0, -0.015));
}

TEST(RestingPointTest, ForceTorqueTellsTheCentreOfPressureInWhateverAttitude) {
  const Eigen::Vector3d corner_F(0.1, -0.05, -0.02);
  const Eigen::Matrix3d R_WF = About({0, 0, 1}, 0.8) * About({0, 1, 0}, 0.2);
  // Friction included, and a moment about the sole's normal, which moves no centre of pressure.
  FootState state = PressedAt(corner_F, {60.0, -40.0, 500.0}, R_WF);
  state.wrench.torque_Nm += R_WF * Eigen::Vector3d(0.0, 0.0, 7.0);
  EXPECT_LT((RestingPoint(Sole(true), state) - R_WF * corner_F).norm(), 1e-12);
}

TEST(RestingPointTest, CentreOfPressureByHand) {
  // 100 N up and 10 N m about y, toes down: 0.1 m behind F. m_y = -x f_z.
  FootState state;
  state.wrench = {{0.0, 0.0, 100.0}, {3.0, 10.0, 0.0}};
  EXPECT_LT((RestingPoint(Sole(true), state) - Eigen::Vector3d(-0.1, 0.03, -0.02)).norm(), 1e-12);
}

TEST(RestingPointTest, CentreOfPressureOffTheSoleIsBroughtBackToIt) {
  const FootState beyond = PressedAt({0.3, -0.2, -0.02}, {0.0, 0.0, 30.0});
  EXPECT_LT((RestingPoint(Sole(true), beyond) - Eigen::Vector3d(0.115, -0.065, -0.02)).norm(),
            1e-12);
}

TEST(RestingPointTest, WithTouchAloneALevelSoleRestsOnItsMiddle) {
  EXPECT_LT((RestingPoint(Sole(false), PressedAt({0.1, 0.05, -0.02}, {0.0, 0.0, 500.0})) -
             Eigen::Vector3d(0.0, 0.0, -0.02))
                .norm(),
            1e-12);
}

TEST(RestingPointTest, WithTouchAloneATiltedSoleRestsOnItsLowestEdge) {
  const Eigen::Matrix3d toes_down = About({0, 1, 0}, 0.1);
  const Eigen::Vector3d edge = toes_down * Eigen::Vector3d(0.1, 0.0, -0.02);
  const FootState state = PressedAt({0.0, 0.0, -0.02}, {0.0, 0.0, 500.0}, toes_down);
  EXPECT_LT((RestingPoint(Sole(false), state) - edge).norm(), 1e-8) << "20 mm against 1 mm of blur";
}

}  // namespace
}  // namespace sidestep::resting_point_test
