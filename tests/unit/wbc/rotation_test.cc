// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sidestep::wbc::rotation_test {
namespace {

using Eigen::Vector3d;

// Rotations are products of a few sines: some units in the last place, times the angle.
constexpr double kRounding = 1e-14;

Eigen::Matrix3d About(const Vector3d& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
}

Eigen::Matrix3d MatrixOf(const Vector3d& vector) {
  return FromRotationVector(vector).toRotationMatrix();
}

TEST(RotationTest, AQuarterTurnAboutZTakesXToY) {
  const Eigen::Quaterniond turn = FromRotationVector({0.0, 0.0, 0.5 * std::numbers::pi});
  EXPECT_LT((turn * Vector3d::UnitX() - Vector3d::UnitY()).norm(), kRounding);
  EXPECT_LT((turn * Vector3d::UnitY() + Vector3d::UnitX()).norm(), kRounding);
}

TEST(RotationTest, ErrorIsWhatIsStillToTurnInTheWorldsAxes) {
  // Pitched by 90 degrees, its x axis points down. To roll about the world's x by 0.2 is to the
  // left of it, R_x R_pitch, and not in its own axes.
  const Eigen::Matrix3d from = About(Vector3d::UnitY(), 0.5 * std::numbers::pi);
  const Eigen::Matrix3d to = About(Vector3d::UnitX(), 0.2) * from;
  EXPECT_LT((RotationError_W(from, to) - Vector3d(0.2, 0.0, 0.0)).norm(), kRounding);
  const Eigen::Matrix3d in_own_axes = from * About(Vector3d::UnitX(), 0.2);
  EXPECT_LT((RotationError_W(from, in_own_axes) - Vector3d(0.0, 0.0, -0.2)).norm(), kRounding);
}

TEST(RotationTest, ThereAndBackAreOppositeAndNoWayIsZero) {
  const Eigen::Matrix3d from = About({1.0, -2.0, 0.5}, 0.7), to = About({0.3, 0.4, -1.0}, 1.1);
  EXPECT_LT((RotationError_W(from, to) + RotationError_W(to, from)).norm(), kRounding);
  EXPECT_LT(RotationError_W(from, from).norm(), 1e-7) << "an angle near 0 is a root of rounding";
}

TEST(RotationTest, TurningByTheErrorArrives) {
  const Eigen::Matrix3d from = About({1.0, -2.0, 0.5}, 0.7);
  for (const double angle_rad : {1e-6, 0.1, 1.0, 3.0}) {
    const Eigen::Matrix3d to = About({0.3, 0.4, -1.0}, angle_rad) * from;
    const Vector3d error = RotationError_W(from, to);
    EXPECT_NEAR(error.norm(), angle_rad, 1e-9);
    EXPECT_LT((MatrixOf(error) * from - to).norm(), 1e-9) << angle_rad;
  }
}

TEST(RotationTest, TakesTheShortWayRound) {
  const Eigen::Matrix3d to = About(Vector3d::UnitZ(), 1.5 * std::numbers::pi);
  const Vector3d error = RotationError_W(Eigen::Matrix3d::Identity(), to);
  EXPECT_NEAR(error.z(), -0.5 * std::numbers::pi, kRounding);
}

TEST(RotationTest, AVectorTooSmallToHaveADirectionTurnsNothingAndTheNextTurnsByItself) {
  EXPECT_EQ(FromRotationVector(Vector3d::Zero()).coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_TRUE(FromRotationVector({0.0, 1e-13, 0.0}).coeffs().allFinite());
  // q = [1, phi / 2] for a small phi.
  EXPECT_NEAR(FromRotationVector({0.0, 1e-9, 0.0}).y(), 0.5e-9, 1e-22);
}

TEST(RotationTest, VectorsOfOneAxisAddAndOthersDoNot) {
  const Vector3d one(0.3, -0.2, 0.4);
  EXPECT_LT((MatrixOf(one) * MatrixOf(0.5 * one) - MatrixOf(1.5 * one)).norm(), kRounding);
  const Vector3d other(-0.2, 0.5, 0.1);
  EXPECT_GT((MatrixOf(one) * MatrixOf(other) - MatrixOf(one + other)).norm(), 0.05);
}

}  // namespace
}  // namespace sidestep::wbc::rotation_test
