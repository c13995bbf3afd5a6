// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/pendulum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sidestep::dcm::pendulum_test {
namespace {

constexpr double kExact = 1e-12;
constexpr double kOmega = 4.0;

// E = 5: steps of 0.2 m ahead leave 0.05 m, steps of 0.18 m across 0.03 m.
TEST(PendulumTest, NominalOffsetIsTheSourcesClosedForm) {
  const Eigen::Vector2d b = NominalOffset({0.2, 0.0}, {0.0, 0.18}, 5.0);
  EXPECT_NEAR(b.x(), 0.05, kExact);
  EXPECT_NEAR(b.y(), 0.03, kExact);
}

TEST(PendulumTest, NominalOffsetComesBackAfterAStepWithItsSignAcross) {
  const double growth = 8.0;
  const Eigen::Vector2d advance(0.1, 0.02), across(0.0, 0.16);
  const Eigen::Vector2d b = NominalOffset(advance, across, growth);
  const Eigen::Vector2d next = growth * b - (advance + across);
  const Eigen::Vector2d expected = NominalOffset(advance, -across, growth);
  EXPECT_NEAR((next - expected).norm(), 0.0, kExact);
}

// E = 3, widths 0.1 to 0.5 m: from (0.5 * 3 - 0.1) / 8 = 0.175 m the widest step leads to
// 0.5 - 0.525 = -0.025 m, and the narrowest back; a hair more and the next is out of bounds.
TEST(PendulumTest, ViableSidewaysAlternatesBetweenItsBounds) {
  const Interval b = ViableSideways({0.1, 0.5}, 3.0);
  EXPECT_NEAR(b.most, 0.175, kExact);
  EXPECT_NEAR(b.least, -0.025, kExact);
  EXPECT_NEAR(0.5 - 3.0 * b.most, b.least, kExact);
  EXPECT_NEAR(0.1 - 3.0 * b.least, b.most, kExact);
}

TEST(PendulumTest, ViableForwardIsWhatTheFarthestStepsBringBack) {
  const Interval b = ViableForward({-0.4, 0.6}, 3.0);
  EXPECT_NEAR(3.0 * b.most - 0.6, b.most, kExact);
  EXPECT_NEAR(3.0 * b.least + 0.4, b.least, kExact);
}

// Both pendulums, over an even transfer of the pressure and over one that jumps, end alike.
TEST(PendulumTest, SwitchDelayStandsForADoubleSupport) {
  constexpr double kBoth_s = 0.3, kWay_m = 0.2;
  const Eigen::Vector2d way(kWay_m, 0.0), end(0.25, 0.0);
  VrpPath even, jump;
  even.Add(0.0, {0.0, 0.0});
  even.Add(kBoth_s, way);
  const double delay_s = SwitchDelay_s(kBoth_s, kOmega);
  jump.Add(0.0, {0.0, 0.0});
  jump.Add(delay_s, {0.0, 0.0});
  jump.Add(delay_s, way);
  jump.Add(kBoth_s, way);
  const Eigen::Vector2d by_even = even.DcmAt(0.0, end, kOmega);
  EXPECT_NEAR((by_even - jump.DcmAt(0.0, end, kOmega)).norm(), 0.0, kExact);
  EXPECT_GT(delay_s, 0.0);
  EXPECT_LT(delay_s, 0.5 * kBoth_s);
  EXPECT_EQ(SwitchDelay_s(0.0, kOmega), 0.0);
}

TEST(PendulumTest, DcmOfAPathObeysThePendulumEverywhere) {
  VrpPath path;
  path.Add(0.0, {0.0, 0.1});
  path.Add(0.1, {0.0, -0.1});
  path.Add(0.5, {0.0, -0.1});
  path.Add(0.6, {0.1, 0.1});
  const Eigen::Vector2d end(0.12, 0.08);
  constexpr double kStep_s = 1e-6;
  for (const double t : {-0.1, 0.03, 0.2, 0.55}) {
    const Eigen::Vector2d rate =
        (path.DcmAt(t + kStep_s, end, kOmega) - path.DcmAt(t - kStep_s, end, kOmega)) /
        (2.0 * kStep_s);
    const Eigen::Vector2d expected = kOmega * (path.DcmAt(t, end, kOmega) - path.At(t));
    EXPECT_NEAR((rate - expected).norm(), 0.0, 1e-8) << t;
  }
  EXPECT_EQ(path.DcmAt(0.6, end, kOmega), end);
}

}  // namespace
}  // namespace sidestep::dcm::pendulum_test
