// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/walking_pendulum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sidestep::limit::walking_pendulum_test {
namespace {

LimitParams Walk() {
  LimitParams params;
  params.omega_per_s = 4.0;
  params.step_length_m = 0.2;
  params.step_width_m = 0.16;
  params.cop_inset_m = 0.02;
  params.swing_s = 0.4;
  params.double_support_s = 0.1;
  return params;
}

TEST(WalkingPendulumTest, WithoutDoubleSupportTheOffsetIsTheTextbooks) {
  LimitParams params = Walk();
  params.double_support_s = 0.0;
  const double growth = std::exp(1.6);
  const Eigen::Vector2d offset_m = LiftOffOffset(params);
  EXPECT_NEAR(offset_m.x(), 0.2 / (growth - 1.0), 1e-12);
  EXPECT_NEAR(offset_m.y(), 0.12 / (growth + 1.0), 1e-12);
}

TEST(WalkingPendulumTest, TheDcmFollowsItsEquationOfMotion) {
  // xi' = omega (xi - p): the centre of pressure rests in the swing and then goes over evenly.
  const LimitParams params = Walk();
  constexpr double kStep_s = 1e-6;
  for (const double time_s : {0.1, 0.3, 0.42, 0.47}) {
    const Eigen::Vector2d rate =
        (WalkAt(params, time_s + kStep_s).dcm_m - WalkAt(params, time_s - kStep_s).dcm_m) /
        (2.0 * kStep_s);
    const double share = std::max(0.0, (time_s - 0.4) / 0.1);
    const Eigen::Vector2d cop_m(0.2 * share, 0.02 + 0.12 * share);
    const Eigen::Vector2d wanted = 4.0 * (WalkAt(params, time_s).dcm_m - cop_m);
    EXPECT_LT((rate - wanted).norm(), 1e-8) << time_s;  // rounding of the difference
  }
}

TEST(WalkingPendulumTest, AStepEndsAsTheNextOneBegins) {
  const LimitParams params = Walk();
  const PendulumState begin = WalkAt(params, 0.0);
  const PendulumState end = WalkAt(params, 0.5 - 1e-9);
  EXPECT_NEAR(end.dcm_m.x() - 0.2, begin.dcm_m.x(), 1e-7);
  EXPECT_NEAR(0.16 - end.dcm_m.y(), begin.dcm_m.y(), 1e-7);  // y turns round
  EXPECT_LT((WalkAt(params, 0.4 + 1e-9).dcm_m - WalkAt(params, 0.4).dcm_m).norm(), 1e-7);
  EXPECT_NEAR(begin.other_foot_m.x(), -0.2, 1e-12);
  EXPECT_NEAR(end.other_foot_m.x(), 0.2, 1e-12);
}

TEST(WalkingPendulumTest, SlowGaitsLoseNoDigits) {
  // e^(omega 10 s) is 10^17: counted forwards, nothing would be left of the DCM.
  LimitParams params = Walk();
  params.swing_s = 5.0;
  params.double_support_s = 5.0;
  const PendulumState end = WalkAt(params, 10.0 - 1e-9);
  EXPECT_NEAR(0.16 - end.dcm_m.y(), WalkAt(params, 0.0).dcm_m.y(), 1e-7);
}

TEST(WalkingPendulumTest, AStandRestsBetweenItsFeet) {
  const PendulumState stand = StandOf(Walk());
  EXPECT_FALSE(stand.is_in_swing);
  EXPECT_EQ(stand.dcm_m, Eigen::Vector2d(0.0, 0.08));
}

}  // namespace
}  // namespace sidestep::limit::walking_pendulum_test
