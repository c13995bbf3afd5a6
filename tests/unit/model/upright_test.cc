// SPDX-License-Identifier: BSD-3-Clause
#include "controller/model/upright.h"

#include <gtest/gtest.h>

#include <numbers>

namespace sidestep::upright_test {
namespace {

constexpr double kRounding = 1e-12;

Eigen::Quaterniond Turn(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

TEST(UprightTest, NoseDownAsksToTurnNoseUp) {
  const Eigen::Vector3d error_rad = UprightError_B(Turn(0.3, Eigen::Vector3d::UnitY()));
  EXPECT_LT((error_rad - Eigen::Vector3d(0.0, -0.3, 0.0)).norm(), kRounding);
}

TEST(UprightTest, LeaningToTheRightAsksToTurnLeft) {
  const Eigen::Vector3d error_rad = UprightError_B(Turn(0.3, Eigen::Vector3d::UnitX()));
  EXPECT_LT((error_rad - Eigen::Vector3d(-0.3, 0.0, 0.0)).norm(), kRounding);
}

TEST(UprightTest, HeadingAloneIsNoError) {
  EXPECT_LT(UprightError_B(Turn(2.0, Eigen::Vector3d::UnitZ())).norm(), kRounding);
}

TEST(UprightTest, TurningByTheErrorMakesTheBaseUpright) {
  const Eigen::Quaterniond q_WB =
      Turn(2.5, Eigen::Vector3d::UnitZ()) * Turn(0.9, Eigen::Vector3d(0.6, -0.8, 0.0));
  const Eigen::Vector3d error_B = UprightError_B(q_WB);
  const Eigen::Quaterniond corrected = q_WB * Turn(error_B.norm(), error_B.normalized());
  EXPECT_LT((corrected * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitZ()).norm(), kRounding);
  EXPECT_EQ(error_B.z(), 0.0) << "a turn about the base's own z is heading";
}

TEST(UprightTest, UpsideDownIsFinite) {
  EXPECT_TRUE(UprightError_B(Turn(std::numbers::pi, Eigen::Vector3d::UnitX())).allFinite());
}

}  // namespace
}  // namespace sidestep::upright_test
