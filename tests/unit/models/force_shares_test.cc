// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/force_shares.h"

#include <gtest/gtest.h>

namespace sidestep::force_shares_test {
namespace {

constexpr double kRoundOff = 1e-14;

Eigen::Matrix3Xd Sole() {
  Eigen::Matrix3Xd vertices_m = Eigen::Matrix3Xd::Zero(3, 4);
  vertices_m.row(0) << 0.1, 0.1, -0.1, -0.1;
  vertices_m.row(1) << 0.05, -0.05, -0.05, 0.05;
  return vertices_m;
}

TEST(ForceSharesTest, AreEqualAtTheMiddleAndLeanTowardsThePointByHand) {
  EXPECT_LT((ForceShares(Sole(), {0.0, 0.0}) - Eigen::Vector4d::Constant(0.25)).norm(), kRoundOff);
  // A tenth of the half width to the right: 1/4 (1 -+ 0.1 / 0.5) with 0.01 m of 0.05 m.
  const Eigen::Vector4d right(0.2, 0.3, 0.3, 0.2);
  EXPECT_LT((ForceShares(Sole(), {0.0, -0.01}) - right).norm(), kRoundOff);
  const Eigen::Vector4d front(0.3, 0.3, 0.2, 0.2);
  EXPECT_LT((ForceShares(Sole(), {0.02, 0.0}) - front).norm(), kRoundOff);
}

TEST(ForceSharesTest, ReachASidesMiddleButNothingOutsideTheDiamond) {
  EXPECT_EQ(ForceShares(Sole(), {0.1, 0.0}).size(), 4);
  EXPECT_EQ(ForceShares(Sole(), {0.06, 0.03}).size(), 0) << "inside the sole, one share negative";
  EXPECT_EQ(ForceShares(Sole(), {0.0, 0.051}).size(), 0) << "outside the sole";
}

TEST(ForceSharesTest, OfAPointFootAreOneAtThePointAndNoneElsewhere) {
  const Eigen::Matrix3Xd point_m = Eigen::Matrix3Xd::Zero(3, 1);
  ASSERT_EQ(ForceShares(point_m, {0.0, 0.0}).size(), 1);
  EXPECT_NEAR(ForceShares(point_m, {0.0, 0.0})(0), 1.0, kRoundOff);
  EXPECT_EQ(ForceShares(point_m, {0.01, 0.0}).size(), 0);
}

}  // namespace
}  // namespace sidestep::force_shares_test
