// SPDX-License-Identifier: BSD-3-Clause
// Forty newtons for a second at the iCub's right hand while it walks, from eight sides, in the
// middle of a swing and of a double support; with step adjustment and without. Long: label
// `cluster`.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

constexpr double kForce_N = 40.0;
constexpr int kDirections = 8;
constexpr double kMidSwing_s = 9.5;  // of the left foot
constexpr double kMidDoubleSupport_s = 8.5;
const std::vector<std::string> kNoAdjustment{"control.mpc.box_lower_m=[0, 0, 0]",
                                             "control.mpc.box_upper_m=[0, 0, 0]"};

std::string Push(double direction_rad, double start_s) {
  char text[160];
  std::snprintf(text, sizeof text,
                "pushes=[{body: r_hand, force_N: [%.4f, %.4f, 0], start_s: %g, duration_s: 1.0}]",
                kForce_N * std::cos(direction_rad), kForce_N * std::sin(direction_rad), start_s);
  return text;
}

// Runs all sixteen, prints a line each, and returns how many the robot survived without a fall.
int CountSurvived(const std::vector<std::string>& settings) {
  int survived = 0;
  for (const double start_s : {kMidSwing_s, kMidDoubleSupport_s}) {
    for (int i = 0; i < kDirections; ++i) {
      const double direction_rad = 2.0 * std::numbers::pi * i / kDirections;
      std::vector<std::string> overrides = settings;
      overrides.push_back(Push(direction_rad, start_s));
      overrides.push_back("expect={fall: false}");
      const ClosedLoopRun run("icub_walk_right_arm_push", overrides);
      const bool has_survived = run.verdict.verdict_class == VerdictClass::kPass;
      std::printf("  %s, %3d degrees: %s\n",
                  start_s == kMidSwing_s ? "mid swing         " : "mid double support",
                  360 * i / kDirections, run.Describe().c_str());
      survived += has_survived ? 1 : 0;
    }
  }
  return survived;
}

TEST(IcubDirectionsTest, SurvivesAtLeastFourteenOfSixteenWithStepAdjustment) {
  EXPECT_GE(CountSurvived({}), 14);
}

// For comparison: 40 N is within what the soles bear where the gait puts them.
TEST(IcubDirectionsTest, SurvivesAtLeastFourteenOfSixteenWithoutStepAdjustment) {
  EXPECT_GE(CountSurvived(kNoAdjustment), 14);
}

}  // namespace
}  // namespace sidestep
