// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/push_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/limit/walking_pendulum.h"

namespace sidestep::limit::push_limit_test {
namespace {

constexpr double kRight = std::numbers::pi * 1.5;  // outwards, as the left foot swings
constexpr double kLeft = std::numbers::pi * 0.5;

LimitTask InPlace(StepFreedom freedom) {
  LimitTask task;
  task.freedom = freedom;
  task.params.sole_half_length_m = 0.105;
  task.params.grid_m = 0.05;  // sanitizers are slow
  task.moments = {{"lift_off", 0.0}};
  task.directions_rad = {0.0, kLeft, std::numbers::pi, kRight};
  return task;
}

TEST(PushLimitTest, FixedFootholdsBearWhatTheSoleDoesAndAStandAfterThem) {
  // Without double support, from omega a ahead the gait goes on. Sideways the next landing may be
  // the last one: outwards the DCM, w / (1 + E) inside, may get to the sole's edge; inwards, from
  // there to w / E beyond the sole, which grows to w by the landing. E = e^(omega 0.4 s) = 5.474.
  LimitTask task = InPlace(StepFreedom::kNone);
  task.params.double_support_s = 0.0;
  const std::vector<double> limits = LargestVelocitySteps(task)[0];
  const double growth = std::exp(4.25 * 0.4);
  EXPECT_NEAR(limits[0], 4.25 * 0.105, 1e-5);
  EXPECT_NEAR(limits[1], 4.25 * (0.045 + 0.16 / growth - 0.16 / (1.0 + growth)), 1e-9);  // 0.210
  EXPECT_NEAR(limits[2], limits[0], 1e-9);
  EXPECT_NEAR(limits[3], 4.25 * (0.045 + 0.16 / (1.0 + growth)), 1e-9);  // 0.296
}

TEST(PushLimitTest, OneStepIsWorthItsLengthLessWhatTheFallTook) {
  // 0.2 s before landing a foot of 2 m/s gets 0.4 m ahead; the step after it would take 2 s, which
  // is for ever. By hand: omega (0.4 e^(-omega 0.2 s) + a).
  LimitTask task = InPlace(StepFreedom::kPlaces);
  task.is_planar = true;
  task.params.swing_s = 2.0;
  task.params.double_support_s = 0.0;
  task.params.swing_speed_mps = 2.0;
  task.moments = {{"late", 1.8}};
  const std::vector<double> limits = LargestVelocitySteps(task)[0];
  const double by_hand_mps = 4.25 * (0.4 * std::exp(-4.25 * 0.2) + 0.105);  // 1.173
  EXPECT_NEAR(limits[0], by_hand_mps, 2e-4);  // the later steps: 0.4 m e^(-omega 2.2 s) omega
  EXPECT_GE(limits[0], by_hand_mps);
}

TEST(PushLimitTest, ASimulatedPendulumStaysJustBelowAndFallsJustAboveIt) {
  // Pushed ahead at mid swing on fixed footholds in place, the best it can do is to have its centre
  // of pressure at the toes until it has caught up.
  LimitTask task = InPlace(StepFreedom::kNone);
  task.directions_rad = {0.0};
  task.moments = {{"mid_swing", 0.2}};
  const double limit_mps = LargestVelocitySteps(task)[0][0];
  const auto ends_near = [&](double push_mps) {
    double dcm_m = WalkAt(task.params, 0.2).dcm_m.x() + push_mps / 4.25;
    for (int i = 0; i < 10000; ++i) {
      dcm_m += 1e-3 * 4.25 * (dcm_m - std::clamp(2.0 * dcm_m, -0.105, 0.105));
    }
    return std::abs(dcm_m) < 0.01;
  };
  EXPECT_TRUE(ends_near(0.99 * limit_mps));
  EXPECT_FALSE(ends_near(1.01 * limit_mps));
}

TEST(PushLimitTest, MoreFreedomIsNeverLess) {
  const std::vector<double> none = LargestVelocitySteps(InPlace(StepFreedom::kNone))[0];
  const std::vector<double> places = LargestVelocitySteps(InPlace(StepFreedom::kPlaces))[0];
  const std::vector<double> free = LargestVelocitySteps(InPlace(StepFreedom::kFree))[0];
  for (std::size_t i = 0; i < none.size(); ++i) {
    EXPECT_GE(places[i], none[i]);
    EXPECT_GE(free[i], places[i]);
  }
  EXPECT_GT(places[0], none[0] + 0.1);
  EXPECT_GT(free[3], places[3] + 0.05) << "outwards, time is what helps";
}

TEST(PushLimitTest, OfTwoFeetThatStandEitherStepsSoLeftIsRight) {
  LimitTask task = InPlace(StepFreedom::kFree);
  task.gait = GaitType::kStand;
  task.moments = EvenMoments(task.params, task.gait, 8);
  ASSERT_EQ(task.moments.size(), 1U);
  const std::vector<double> limits = LargestVelocitySteps(task)[0];
  EXPECT_NEAR(limits[1], limits[3], 1e-9);
  EXPECT_GT(limits[1], 4.25 * (0.08 + 0.045)) << "it may do better than stand on one edge";
}

TEST(PushLimitTest, ARobotTwiceAsLargeAndAsFastTakesTwiceThePush) {
  const LimitTask small = InPlace(StepFreedom::kPlaces);
  LimitTask large = small;
  LimitParams& params = large.params;
  for (double* length : {&params.sole_half_length_m, &params.sole_half_width_m, &params.reach_m,
                         &params.step_width_m, &params.nearest_m, &params.farthest_m,
                         &params.swing_speed_mps, &params.grid_m}) {
    *length *= 2.0;
  }
  const std::vector<double> once = LargestVelocitySteps(small)[0];
  const std::vector<double> twice = LargestVelocitySteps(large)[0];
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(twice[i], 2.0 * once[i], 1e-5);
}

TEST(PushLimitTest, APlanarRobotHasNothingSideways) {
  LimitTask task = InPlace(StepFreedom::kFree);
  task.is_planar = true;
  task.directions_rad = EvenDirections(16, true);
  ASSERT_EQ(task.directions_rad.size(), 2U);
  const std::vector<double> planar = LargestVelocitySteps(task)[0];
  task.params.nearest_m = task.params.farthest_m = 0.0;  // would be no place for a second foot
  EXPECT_EQ(LargestVelocitySteps(task)[0], planar);
  EXPECT_NEAR(planar[0], planar[1], 1e-9);
}

TEST(PushLimitTest, AHopIsTheSameToAllSidesAndNeedsItsSteps) {
  LimitTask task = InPlace(StepFreedom::kFree);
  task.gait = GaitType::kHop;
  const std::vector<double> limits = LargestVelocitySteps(task)[0];
  EXPECT_GT(limits[0], 0.0);
  EXPECT_EQ(limits, std::vector<double>(4, limits[0]));
  task.freedom = StepFreedom::kNone;
  EXPECT_EQ(LargestVelocitySteps(task)[0][0], 0.0);
}

TEST(HeldPushFactorTest, AShortPushIsAnInstantOneAndALongOneCountsByItsForce) {
  EXPECT_EQ(HeldPushFactor(4.25, 0.0), 1.0);
  EXPECT_NEAR(HeldPushFactor(4.25, 0.1), 1.2275, 1e-4);  // 0.425 / (1 - e^-0.425)
  EXPECT_NEAR(HeldPushFactor(4.25, 10.0), 42.5, 1e-9);   // of the force J / t, only omega is left
}

TEST(PushMomentsTest, AreNamedOrEvenlySpread) {
  const LimitParams params;  // 0.4 s and 0.1 s
  const std::vector<PushMoment> even = EvenMoments(params, GaitType::kWalk, 8);
  ASSERT_EQ(even.size(), 8U);
  EXPECT_EQ(even[1].name, "12.5%");
  EXPECT_EQ(even[4].name, "50%");
  EXPECT_DOUBLE_EQ(even[4].time_s, 0.25);
  const std::vector<PushMoment> named = NamedMoments(params, GaitType::kWalk);
  ASSERT_EQ(named.size(), 4U);
  EXPECT_DOUBLE_EQ(named[2].time_s, 0.35);
  EXPECT_DOUBLE_EQ(named[3].time_s, 0.45);
  EXPECT_EQ(NamedMoments(params, GaitType::kHop)[0].name, "touch_down");
}

}  // namespace
}  // namespace sidestep::limit::push_limit_test
