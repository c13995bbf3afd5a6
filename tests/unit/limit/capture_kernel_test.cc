// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/capture_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sidestep::limit::capture_kernel_test {
namespace {

constexpr double kOmega_per_s = 4.0;
constexpr StepTimes kTimes{0.5, 0.0};        // one foot leaves as the other lands
const double kGrowth = std::exp(0.5 * 4.0);  // e^2 = 7.389
constexpr double kSettled = 1e-6;            // where the recursion ends

LimitParams Params() {
  LimitParams params;
  params.sole_half_length_m = 0.1;
  params.sole_half_width_m = 0.05;
  params.step_length_m = 0.2;
  params.step_width_m = 0.16;
  return params;
}

TEST(BeforeTest, RunsThePendulumBackFromATarget) {
  // By hand: from 0.3 about a centre of pressure at 0.1, a growth of 2 came from 0.2.
  const Interval before = Before({0.3, 0.5}, {0.1, 0.1}, 2.0);
  EXPECT_DOUBLE_EQ(before.lo, 0.2);
  EXPECT_DOUBLE_EQ(before.hi, 0.3);
  EXPECT_TRUE(Before({}, {0.0, 0.1}, 2.0).is_empty());
}

TEST(CaptureKernelTest, FixedFootholdsLeaveTheSoleAboutTheGaitsOwnOffset) {
  // xi = b + xi_next / E in each axis: about L / (E - 1) ahead, w / (E + 1) aside, the sole's half.
  const StepAxis forward = ForwardAxis(Params(), StepFreedom::kNone);
  const Kernel x = HeldForEver(forward, kOmega_per_s, kTimes);
  ASSERT_EQ(x.size(), 1U);
  EXPECT_NEAR(x[0].hi, 0.2 / (kGrowth - 1.0) + 0.1, kSettled);
  EXPECT_NEAR(x[0].lo, 0.2 / (kGrowth - 1.0) - 0.1, kSettled);
  const StepAxis sideways = SidewaysAxis(Params(), StepFreedom::kNone);
  const Kernel y = HeldForEver(sideways, kOmega_per_s, kTimes);
  ASSERT_EQ(y.size(), 1U);
  EXPECT_NEAR(y[0].hi, 0.16 / (kGrowth + 1.0) + 0.05, kSettled);
  EXPECT_NEAR(y[0].lo, 0.16 / (kGrowth + 1.0) - 0.05, kSettled);
}

TEST(CaptureKernelTest, StepsOfFullReachHoldWhatKoolenSays) {
  // The longest step l for ever: half the sole and l / (E - 1); here l is bound by reach.
  LimitParams params = Params();
  params.reach_m = 0.4;
  params.swing_speed_mps = 10.0;
  const Kernel kernel =
      HeldForEver(ForwardAxis(params, StepFreedom::kPlaces), kOmega_per_s, kTimes);
  for (const Interval& held : kernel) {
    EXPECT_NEAR(held.hi, 0.1 + 0.4 / (kGrowth - 1.0), kSettled);
    EXPECT_NEAR(held.lo, -0.1 - 0.4 / (kGrowth - 1.0), kSettled);
  }
}

TEST(CaptureKernelTest, ASlowFootHoldsLessTheFartherItIsBehind) {
  // Both feet swing by turns, so steps of l need 2 l in a swing: 0.6 m/s for 0.5 s makes 0.15 m.
  LimitParams params = Params();
  params.reach_m = 0.4;
  params.grid_m = 0.05;
  params.swing_speed_mps = 0.6;
  const StepAxis axis = ForwardAxis(params, StepFreedom::kPlaces);
  const Kernel kernel = HeldForEver(axis, kOmega_per_s, kTimes);
  const std::size_t behind = axis.OriginAfter(0.15);
  EXPECT_NEAR(axis.origins_m[behind], -0.15, 1e-12);
  EXPECT_NEAR(kernel[behind].hi, 0.1 + 0.15 / (kGrowth - 1.0), kSettled);
  EXPECT_GT(kernel[axis.OriginAfter(-0.15)].hi, kernel[behind].hi + 0.01);
}

TEST(CaptureKernelTest, ATimeOnBothFeetLetsTheCentreOfPressureGoAhead) {
  // By hand, growths 2 and 2, foot at 0.2 next, half sole 0.1, after [-0.1, 0.1] there:
  // at landing (0.2 + 0.1 + 0.3) / 2 = 0.3, at lift-off (0.3 + 0.1) / 2 = 0.2; and
  // (0.2 - 0.1 - 0.1) / 2 = 0, (0 - 0.1) / 2 = -0.05.
  const double doubling_s = std::log(2.0) / kOmega_per_s;
  const StepAxis axis = ForwardAxis(Params(), StepFreedom::kNone);
  const Kernel before =
      BeforeStep(axis, kOmega_per_s, {doubling_s, doubling_s}, {Around(0.0, 0.1)});
  EXPECT_NEAR(before[0].hi, 0.2, 1e-12);
  EXPECT_NEAR(before[0].lo, -0.05, 1e-12);
}

TEST(CaptureKernelTest, NothingIsHeldWhereNoFootholdIsReached) {
  LimitParams params = Params();
  params.nearest_m = 0.3;
  params.swing_speed_mps = 0.01;
  params.crossing_m = 0.2;  // a foot may stand across, but in the first step alone
  const StepAxis axis = SidewaysAxis(params, StepFreedom::kPlaces);
  const Kernel kernel = HeldForEver(axis, kOmega_per_s, kTimes);
  EXPECT_TRUE(kernel[axis.OriginAfter(-0.1)].is_empty());
  EXPECT_FALSE(kernel[axis.OriginAfter(0.3)].is_empty());
}

TEST(CaptureKernelTest, AKernelForEveryChoiceOfThreeSwings) {
  const StepAxis axis = ForwardAxis(Params(), StepFreedom::kNone);
  EXPECT_EQ(KernelsOf(axis, kOmega_per_s, {0.3, 0.5}, 0.1).size(), 8U);
}

}  // namespace
}  // namespace sidestep::limit::capture_kernel_test
