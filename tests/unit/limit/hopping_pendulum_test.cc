// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/hopping_pendulum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sidestep::limit::hopping_pendulum_test {
namespace {

LimitParams Hop() {
  LimitParams params;
  params.omega_per_s = std::sqrt(9.81 / 0.5);
  params.stance_s = 0.15;
  params.flight_s = 0.15;
  params.reach_m = 0.3;
  params.swing_speed_mps = 4.0;
  return params;
}

// In stance twice the weight: sqrt(2 g / h).
const double kOmega_per_s = std::sqrt(2.0 * 9.81 / 0.5);

TEST(HopLimitTest, AtLiftOffReachAloneBoundsIt) {
  const double closed_form_mps = kOmega_per_s * 0.3 / std::tanh(0.5 * kOmega_per_s * 0.15);
  EXPECT_NEAR(HopLimit(Hop(), 0.1500001), closed_form_mps, 1e-5);  // 4.290
}

TEST(HopLimitTest, AtTouchDownTheComMustNotLeaveTheFootBehind) {
  // The foot is below the CoM and stays: v sinh(omega stance) / omega is the reach.
  const double closed_form_mps = 0.3 * kOmega_per_s / std::sinh(kOmega_per_s * 0.15);
  EXPECT_NEAR(HopLimit(Hop(), 0.0), closed_form_mps, 1e-7);  // 1.733
}

TEST(HopLimitTest, LateInFlightTheFootsSpeedBoundsIt) {
  // 15 ms are left for 0.06 m: v sinh / omega - 0.06 cosh is the reach.
  const double closed_form_mps =
      kOmega_per_s * (0.3 + 0.06 * std::cosh(kOmega_per_s * 0.15)) / std::sinh(kOmega_per_s * 0.15);
  EXPECT_NEAR(HopLimit(Hop(), 0.285), closed_form_mps, 1e-7);  // 2.244
}

TEST(HopLimitTest, MatchesASearchOfTheGridOfItsStates) {
  // Speeds 0.01 m/s and feet 7.5 mm apart: states rounded so are worth about 0.02 m/s.
  EXPECT_NEAR(HopLimit(Hop(), 0.075), 3.85, 0.02);
  EXPECT_NEAR(HopLimit(Hop(), 0.135), 4.27, 0.02);
  EXPECT_NEAR(HopLimit(Hop(), 0.225), 4.29, 0.02);
}

TEST(HopLimitTest, AFootThatDoesNotMoveCatchesNothingInFlight) {
  LimitParams params = Hop();
  params.swing_speed_mps = 0.01;
  EXPECT_LT(HopLimit(params, 0.2), 0.1);
  EXPECT_LT(HopLimit(params, 0.0), HopLimit(Hop(), 0.0));
}

}  // namespace
}  // namespace sidestep::limit::hopping_pendulum_test
