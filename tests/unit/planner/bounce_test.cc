// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/bounce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/support/gravity.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::bounce_test {
namespace {

GaitParams Hop(double stance_s, double flight_s) {
  GaitParams hop = Stretch(GaitType::kHop, 0.0);
  hop.stance_s = stance_s;
  hop.flight_s = flight_s;
  return hop;
}

TEST(BounceTest, AHalfWaveOfForceTurnsTheFallIntoTheNextFlight) {
  const GaitParams hop = Hop(0.2, 0.3);
  const Bounce bounce = BounceOf(hop);
  double velocity_mps = -0.5 * kGravity_mps2 * hop.flight_s;  // at touch-down
  double height_m = 0.0;
  double lowest_m = 0.0;
  constexpr int kSteps = 20000;
  const double dt_s = hop.stance_s / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    velocity_mps += dt_s * bounce.stance_mps2 * std::sin(std::numbers::pi * (i + 0.5) / kSteps);
    height_m += dt_s * velocity_mps;
    lowest_m = std::min(lowest_m, height_m);
  }
  EXPECT_NEAR(velocity_mps, 0.5 * kGravity_mps2 * hop.flight_s, 1e-6);
  EXPECT_NEAR(height_m, 0.0, 1e-4) << "as high at lift-off as at touch-down";
  EXPECT_NEAR(lowest_m, -bounce.depth_m, 1e-4);
}

TEST(BounceTest, TheApexIsThatOfAFreeFall) {
  const double half_s = 0.15;
  EXPECT_NEAR(BounceOf(Hop(0.2, 2.0 * half_s)).rise_m, 0.5 * kGravity_mps2 * half_s * half_s,
              1e-12);
}

TEST(BounceTest, WithoutFlightThereIsNone) {
  const Bounce bounce = BounceOf(Hop(0.2, 0.0));
  EXPECT_EQ(bounce.rise_m, 0.0);
  EXPECT_EQ(bounce.depth_m, 0.0);
  EXPECT_EQ(bounce.stance_mps2, 0.0);
}

// The nominal CoM of a hop in place against free fall and the half wave, phase by phase.
TEST(BounceTest, TheNominalComOfAHopFallsFreelyInFlight) {
  const GaitParams hop = Hop(0.2, 0.2);
  GaitParams in_place = hop;
  in_place.step_length_m = 0.0;
  const GaitSetup setup = SetupOf({in_place}, 1);
  const NominalGait gait = BuildNominalGait(setup.segments, setup.geometry, 4000, kTick_s);
  const Bounce bounce = BounceOf(hop);
  EXPECT_NEAR(NominalComAt(gait, 2100, kTick_s).p_WC.z(), kComHeight_m - bounce.depth_m, 1e-12);
  EXPECT_NEAR(NominalComAt(gait, 2300, kTick_s).p_WC.z(), kComHeight_m + bounce.rise_m, 1e-12);
  double least_mps2 = 0.0;
  for (Tick tick = 2200; tick <= 2400; ++tick) {  // in the air
    const double since_s = SecondsAt(tick - 2200, kTick_s);
    const double free_m = kComHeight_m + 0.5 * kGravity_mps2 * since_s * (hop.flight_s - since_s);
    const ComReference com = NominalComAt(gait, tick, kTick_s);
    EXPECT_NEAR(com.p_WC.z(), free_m, 0.05 * (bounce.rise_m + bounce.depth_m)) << tick;
    least_mps2 = std::min(least_mps2, com.a_WC.z());
  }
  EXPECT_NEAR(least_mps2, -kGravity_mps2, 0.25 * kGravity_mps2);
}

}  // namespace
}  // namespace sidestep::bounce_test
