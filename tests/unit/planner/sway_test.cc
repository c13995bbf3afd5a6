// SPDX-License-Identifier: BSD-3-Clause
// The closed forms against a pendulum integrated step by step.
#include "controller/planner/sway.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/planner/contact_schedule.h"
#include "models/support/gravity.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::sway_test {
namespace {

constexpr double kHeight_m = 0.54;
const ComSway kPendulum{SwayMode::kPendulum};

GaitParams Walk(double swing_s, double double_support_s) {
  GaitParams walk = Stretch(GaitType::kWalk, 0.0);
  walk.step_length_m = 0.0;
  walk.swing_s = swing_s;
  walk.double_support_s = double_support_s;
  return walk;
}

// CoP (m) at `time_s` after the middle of a double support: from the foot at -1 to the one at 1.
double CopAt(double time_s, const GaitParams& walk) {
  const double half_s = 0.5 * walk.double_support_s;
  return time_s < half_s ? time_s / half_s : 1.0;
}

class SwayTest : public testing::TestWithParam<std::array<double, 2>> {};

INSTANTIATE_TEST_SUITE_P(Times, SwayTest,
                         testing::Values(std::array{0.3, 0.05}, std::array{0.4, 0.1},
                                         std::array{0.6, 0.3}, std::array{1.0, 1.0},
                                         std::array{0.3, 0.001}));

// From the path with the crossing speed, half a step later it turns at the sway's end.
TEST_P(SwayTest, ThePendulumThatCrossesSoTurnsInMidSwing) {
  const GaitParams walk = Walk(GetParam()[0], GetParam()[1]);
  const Sway sway = SwayOf(kPendulum, walk, kHeight_m);
  const double step_s = walk.swing_s + walk.double_support_s;
  const double square_per_s2 = kGravity_mps2 / kHeight_m;
  constexpr int kSteps = 200000;
  const double dt_s = 0.5 * step_s / kSteps;
  double y = 0.0, v = sway.haste * 2.0 * sway.share / step_s;
  for (int i = 0; i < kSteps; ++i) {  // leapfrog
    v += 0.5 * dt_s * square_per_s2 * (y - CopAt(i * dt_s, walk));
    y += dt_s * v;
    v += 0.5 * dt_s * square_per_s2 * (y - CopAt((i + 1) * dt_s, walk));
  }
  EXPECT_NEAR(y, sway.share, 1e-4);
  EXPECT_NEAR(v, 0.0, 1e-3);
  EXPECT_NEAR(sway.turn_back_per_s2, square_per_s2 * (1.0 - y), 1e-2);
}

TEST(SwayOfShareTest, IsTheShareAndNothingElse) {
  const Sway sway = SwayOf({SwayMode::kShare, 0.3}, Walk(0.4, 0.1), kHeight_m);
  EXPECT_EQ(sway.share, 0.3);
  EXPECT_EQ(sway.haste, 1.0);
  EXPECT_EQ(sway.turn_back_per_s2, 0.0);
}

// In a second on each foot and one on both the pendulum goes nearly all the way.
TEST(SwayOfPendulumTest, GoesNoFartherThanItIsAsked) {
  EXPECT_GT(SwayOf(kPendulum, Walk(1.0, 1.0), kHeight_m).share, 0.8);
  const Sway sway = SwayOf({SwayMode::kPendulum, 0.8}, Walk(1.0, 1.0), kHeight_m);
  EXPECT_EQ(sway.share, 0.8);
  EXPECT_EQ(sway.haste, 1.0);
  EXPECT_EQ(SwayOf({SwayMode::kPendulum, 0.8}, Walk(0.3, 0.05), kHeight_m).share,
            SwayOf(kPendulum, Walk(0.3, 0.05), kHeight_m).share);
}

// The capture point of the reference is that of the pendulum: in mid-swing, and while it crosses.
TEST(SwayReferenceTest, AWalksReferenceTurnsAndCrossesLikeThePendulum) {
  const GaitParams walk = Walk(0.3, 0.05);
  GaitGeometry geometry = Geometry(2);
  geometry.com_height_m = kHeight_m;
  geometry.sway = kPendulum;
  const NominalGait gait = BuildNominalGait({walk}, geometry, 6000, kTick_s);
  const Sway sway = SwayOf(kPendulum, walk, kHeight_m);
  const double half_m = 0.5 * walk.step_width_m;
  const ComReference turns = NominalComAt(gait, 1400 + 25 + 175, kTick_s);
  EXPECT_NEAR(std::abs(turns.p_WC.y()), sway.share * half_m, 1e-9);
  EXPECT_NEAR(turns.v_WC.y(), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(turns.a_WC.y()), sway.turn_back_per_s2 * half_m, 1e-9);
  const ComReference crosses = NominalComAt(gait, 1400 + 25, kTick_s);
  EXPECT_NEAR(std::abs(crosses.v_WC.y()), sway.haste * 2.0 * sway.share * half_m / 0.35, 1e-9);
}

}  // namespace
}  // namespace sidestep::sway_test
