// SPDX-License-Identifier: BSD-3-Clause
#include "controller/push_alarm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/support/gravity.h"

namespace sidestep::push_alarm_test {
namespace {

constexpr double kError_m = 0.04, kAlert_s = 1.0, kHeight_m = 0.5, kMass_kg = 50.0;
constexpr double kTick_s = 0.001;
constexpr Tick kSolve = 50;

class PushAlarmTest : public testing::Test {
 protected:
  /// Asks at the next solve, the CoM `faster_mps` than planned.
  bool Next(double faster_mps, double felt_N = 0.0) {
    RobotState state;
    state.p_WC = planned_.p_WC;
    state.v_WC = planned_.v_WC + Eigen::Vector3d(faster_mps, 0.0, 0.0);
    state.external_wrench.force_N.y() = felt_N;
    tick_ += kSolve;
    return alarm_.Update(state, planned_, tick_);
  }

  PushAlarm alarm_{kError_m, kAlert_s, kHeight_m, kMass_kg, kTick_s};
  ComTarget planned_;
  Tick tick_{0};
};

TEST_F(PushAlarmTest, AsPlannedThereIsNone) {
  planned_.v_WC << 0.5, 0.1, 0.0;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(Next(0.0));
}

// 0.02 m/s are 4.5 mm of the capture point; every 50 ms that adds up to 20 mm.
TEST_F(PushAlarmTest, SmallErrorsAreForgotten) {
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(Next(0.02)) << i;
}

TEST_F(PushAlarmTest, ErrorsToAndFroCancel) {
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(Next(i % 2 == 0 ? 0.12 : -0.12)) << i;
}

TEST_F(PushAlarmTest, AShoveIsNoticedAtOnceAndCountsForItsTime) {
  EXPECT_TRUE(Next(0.25));  // 56 mm
  // Below the bound again after 0.2 s ln(56 / 40) = 68 ms, so two solves on notice.
  const int alert = static_cast<int>(kAlert_s / kTick_s) / static_cast<int>(kSolve);
  for (int i = 0; i < alert + 1; ++i) EXPECT_TRUE(Next(0.0)) << i;
  EXPECT_FALSE(Next(0.0));
}

TEST_F(PushAlarmTest, APushThatGoesOnAddsUp) {
  const double faster_mps = 0.05;  // 11 mm a solve: 1 m/s^2
  int solves = 1;
  while (solves < 100 && !Next(faster_mps)) ++solves;
  EXPECT_GT(solves, 3);
  EXPECT_LT(solves, 10);
}

TEST_F(PushAlarmTest, AFeltPushCountsByTheBalanceItTakes) {
  const double stiffness_N_m = kMass_kg * kGravity_mps2 / kHeight_m;  // m w^2
  EXPECT_FALSE(Next(0.0, 0.99 * kError_m * stiffness_N_m));
  EXPECT_TRUE(Next(0.0, 1.01 * kError_m * stiffness_N_m));
}

}  // namespace
}  // namespace sidestep::push_alarm_test
