// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/momentum_reference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sidestep::momentum_reference_test {
namespace {

constexpr double kRate_radps = 4.0;
const Eigen::Matrix3d kInertia_B = Eigen::Vector3d(1.0, 2.0, 3.0).asDiagonal();

Eigen::Quaterniond Turned(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

TEST(MomentumReferenceTest, AnUprightBaseNeedsNoneWhateverItsHeading) {
  const Eigen::Quaterniond heading = Turned(1.0, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(LevellingMomentum(Eigen::Quaterniond::Identity(), kInertia_B, kRate_radps).norm(), 0.0);
  EXPECT_LT(LevellingMomentum(heading, kInertia_B, kRate_radps).norm(), 1e-12);
}

TEST(MomentumReferenceTest, ALeanToTheFrontIsTurnedBack) {
  // By hand: leaning to +x is a rotation by +0.1 rad about y; undoing it at 4 /s is -0.4 rad/s
  // about y, and with 2 kg m^2 there -0.8 kg m^2/s.
  const Eigen::Quaterniond q_WB = Turned(0.1, Eigen::Vector3d::UnitY());
  const Eigen::Vector3d momentum = LevellingMomentum(q_WB, kInertia_B, kRate_radps);
  EXPECT_LT((momentum - Eigen::Vector3d(0.0, -0.8, 0.0)).norm(), 1e-12);
}

TEST(MomentumReferenceTest, TheLeanIsThatOfTheWorldWhereverTheBaseFaces) {
  // Facing +y and leaning to its own front, the base leans to +y: a rotation about -x of the world.
  const Eigen::Quaterniond q_WB =
      Turned(M_PI / 2, Eigen::Vector3d::UnitZ()) * Turned(0.1, Eigen::Vector3d::UnitY());
  const Eigen::Vector3d momentum = LevellingMomentum(q_WB, kInertia_B, kRate_radps);
  EXPECT_LT((momentum - Eigen::Vector3d(0.8, 0.0, 0.0)).norm(), 1e-12);
}

TEST(MomentumReferenceTest, NoMomentumIsAskedForAboutTheVertical) {
  Eigen::Matrix3d skewed = kInertia_B;
  skewed(1, 2) = skewed(2, 1) = 0.5;  // would ask for 0.2 kg m^2/s about z
  const Eigen::Quaterniond q_WB = Turned(0.1, Eigen::Vector3d::UnitX());
  skewed(0, 2) = skewed(2, 0) = 0.5;
  const Eigen::Vector3d momentum = LevellingMomentum(q_WB, skewed, kRate_radps);
  EXPECT_EQ(momentum.z(), 0.0);
  EXPECT_LT(momentum.x(), -0.3);
}

TEST(MomentumReferenceTest, AZeroRateAsksForNone) {
  const Eigen::Quaterniond q_WB = Turned(0.5, Eigen::Vector3d::UnitY());
  EXPECT_EQ(LevellingMomentum(q_WB, kInertia_B, 0.0).norm(), 0.0);
}

TEST(MomentumReferenceTest, ItDecaysFromWhatItIsNow) {
  const Eigen::Vector3d now(1.0, -2.0, 0.0);
  EXPECT_EQ(MomentumReference(now, kRate_radps, 0.0), now);
  EXPECT_LT((MomentumReference(now, kRate_radps, 0.05) - std::exp(-0.2) * now).norm(), 1e-12);
  EXPECT_EQ(MomentumReference(now, 0.0, 0.05), now);
}

TEST(MomentumReferenceTest, FollowedToTheEndItTurnsTheBaseByItsLean) {
  // The integral of w* = k theta exp(-k t) is theta: here over 5 s, twenty time constants, by the
  // midpoint rule, whose error is (k T)^2 / 24 of theta.
  constexpr double kLean_rad = 0.2, kStep_s = 1e-3;
  const Eigen::Quaterniond q_WB = Turned(kLean_rad, Eigen::Vector3d::UnitY());
  const Eigen::Vector3d momentum = LevellingMomentum(q_WB, kInertia_B, kRate_radps);
  double turned_rad = 0.0;
  for (int k = 0; k < 5000; ++k) {
    const Eigen::Vector3d middle = MomentumReference(momentum, kRate_radps, (k + 0.5) * kStep_s);
    turned_rad += middle.y() * kStep_s / kInertia_B(1, 1);
  }
  EXPECT_NEAR(turned_rad, -kLean_rad, 1e-6);
}

}  // namespace
}  // namespace sidestep::momentum_reference_test
