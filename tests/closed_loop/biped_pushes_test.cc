// SPDX-License-Identifier: BSD-3-Clause
// How hard the planar biped may be shoved while it walks and while it runs: forwards and backwards,
// at eight instants of a step, for a tenth and for half a second, with step adjustment and without.
// Long: label `cluster`.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

constexpr double kMass_kg = 1.0;
constexpr int kPhases = 8;
constexpr double kFirstPush_s = 5.3;
constexpr double kAfter_s = 5.0;
const std::vector<std::string> kNoAdjustment{"control.mpc.box_lower_m=[0, 0, 0]",
                                             "control.mpc.box_upper_m=[0, 0, 0]"};

// One way of being pushed: a ladder of impulses over the mass (N s/kg) at each instant.
struct Ladder {
  std::string scenario;
  double step_s;
  double duration_s;
  std::vector<double> rungs;
};

bool Survives(const Ladder& ladder, double start_s, double impulse,
              std::vector<std::string> overrides) {
  char text[160];
  std::snprintf(text, sizeof text,
                "pushes=[{body: torso, force_N: [%.6f, 0, 0], start_s: %.4f, duration_s: %g}]",
                impulse * kMass_kg / ladder.duration_s, start_s, ladder.duration_s);
  overrides.emplace_back(text);
  overrides.emplace_back("duration_s=" + std::to_string(start_s + ladder.duration_s + kAfter_s));
  overrides.emplace_back("expect={fall: false}");
  const ClosedLoopRun run(ladder.scenario, overrides);
  return run.verdict.verdict_class == VerdictClass::kPass;
}

// The highest rung that is survived with all below it, in the mean over the cells. Prints them.
double MeanSurvived(const Ladder& ladder, const std::vector<std::string>& overrides) {
  double sum = 0.0;
  for (const double sign : {1.0, -1.0}) {
    std::printf("  %s, %g s, %s:", ladder.scenario.c_str(), ladder.duration_s,
                sign > 0.0 ? "forwards " : "backwards");
    for (int phase = 0; phase < kPhases; ++phase) {
      const double start_s = kFirstPush_s + ladder.step_s * phase / kPhases;
      double survived = 0.0;
      for (const double rung : ladder.rungs) {
        if (!Survives(ladder, start_s, sign * rung, overrides)) break;
        survived = rung;
      }
      std::printf(" %4.2f", survived);
      sum += survived;
    }
    std::printf("\n");
  }
  const double mean = sum / (2 * kPhases);
  std::printf("  mean %.3f N s/kg\n", mean);
  return mean;
}

class BipedPushesTest : public testing::TestWithParam<Ladder> {};

TEST_P(BipedPushesTest, StepAdjustmentIsWorthHalfAsMuchAgain) {
  const double with = MeanSurvived(GetParam(), {});
  const double without = MeanSurvived(GetParam(), kNoAdjustment);
  EXPECT_GE(with, 1.5 * without);
}

INSTANTIATE_TEST_SUITE_P(
    Ladders, BipedPushesTest,
    testing::Values(
        Ladder{"biped_walk",
               0.4,
               0.1,
               {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6}},
        Ladder{"biped_walk",
               0.4,
               0.5,
               {0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4, 2.6, 2.8, 3.0}},
        Ladder{"biped_run", 0.3, 0.1, {0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4}},
        Ladder{"biped_run", 0.3, 0.5, {0.4, 0.8, 1.2, 1.6, 2.0, 2.4, 2.8, 3.2, 3.6, 4.0}}));

}  // namespace
}  // namespace sidestep
