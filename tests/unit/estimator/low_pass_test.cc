// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/low_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sidestep::low_pass_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(LowPassTest, GoesHalfWayWhereACutoffsRadianIsAStep) {
  // r = 2 pi f dt = 1, share = r / (1 + r).
  EXPECT_NEAR(LowPassShare(1.0 / (2.0 * kPi * 0.01), 0.01), 0.5, 1e-15);
  EXPECT_NEAR(LowPassShare(3.0 / (2.0 * kPi * 0.01), 0.01), 0.75, 1e-15);
}

TEST(LowPassTest, NeverStaysBehindForGoodNorOvershoots) {
  EXPECT_EQ(LowPassShare(0.0, 0.01), 0.0) << "a cutoff of zero lets nothing through";
  double last = 0.0;
  for (const double cutoff_hz : {0.1, 3.0, 10.0, 1e3, 1e6}) {
    const double share = LowPassShare(cutoff_hz, 0.005);
    EXPECT_GT(share, last) << cutoff_hz;
    EXPECT_LT(share, 1.0) << cutoff_hz;
    last = share;
  }
}

TEST(LowPassTest, AStepIsFollowedToOneMinusOneOverEInOneTimeConstant) {
  // After n steps of r each: 1 - (1 + r)^-n, and with n r = 1 that tends to 1 - 1/e; the error of
  // the implicit Euler method is r / (2 e) to first order.
  constexpr double kCutoff_hz = 5.0;
  for (const int steps : {10, 100, 1000}) {
    const double dt_s = 1.0 / (2.0 * kPi * kCutoff_hz * steps);
    double value = 0.0;
    for (int i = 0; i < steps; ++i) value += LowPassShare(kCutoff_hz, dt_s) * (1.0 - value);
    EXPECT_NEAR(value, 1.0 - std::pow(1.0 + 1.0 / steps, -steps), 1e-12);
    EXPECT_NEAR(value, 1.0 - 1.0 / std::numbers::e, 0.6 / (std::numbers::e * steps));
  }
}

// Largest value of a sine's low-pass from 2 s to 4 s, when the start is forgotten, at 0.1 ms.
double AmplitudeOf(double frequency_hz, double cutoff_hz) {
  constexpr double kStep_s = 1e-4;
  const double share = LowPassShare(cutoff_hz, kStep_s);
  double value = 0.0, amplitude = 0.0;
  for (int i = 0; i < 40000; ++i) {
    value += share * (std::sin(2.0 * kPi * frequency_hz * i * kStep_s) - value);
    if (i > 20000) amplitude = std::max(amplitude, value);
  }
  return amplitude;
}

TEST(LowPassTest, HalvesThePowerAtItsCutoffAndFallsByTenADecadeAbove) {
  // |H| = 1 / sqrt(1 + (f / f_c)^2); a step of 0.1 ms is 0.3 % of the time constant at 5 Hz.
  constexpr double kCutoff_hz = 5.0;
  for (const double frequency_hz : {0.5, 5.0, 50.0}) {
    const double ratio = frequency_hz / kCutoff_hz;
    const double expected = 1.0 / std::sqrt(1.0 + ratio * ratio);
    EXPECT_NEAR(AmplitudeOf(frequency_hz, kCutoff_hz), expected, 0.005 * expected) << frequency_hz;
  }
}

}  // namespace
}  // namespace sidestep::low_pass_test
