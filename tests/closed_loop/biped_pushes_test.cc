// SPDX-License-Identifier: BSD-3-Clause
// How hard the planar bipeds may be shoved while they walk and while they run: forwards and
// backwards, at eight instants of a step, for a tenth and for half a second, with step adjustment
// and without. Long: label `cluster`.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

constexpr int kPhases = 8;
constexpr double kFirstPush_s = 5.3;
constexpr double kAfter_s = 5.0;
const std::vector<std::string> kNoAdjustment{"control.mpc.box_lower_m=[0, 0, 0]",
                                             "control.mpc.box_upper_m=[0, 0, 0]"};

// One way of being pushed: at each instant by `rung`, 2 `rung`, ... of impulse over the mass
// (N s/kg). All rungs are tried, since survival is not monotonic.
struct Ladder {
  std::string scenario;
  double mass_kg;
  double step_s;
  double duration_s;
  double rung;
  int rungs;
};

// What one ladder showed.
struct Cell {
  double survived;  // the highest rung that is survived with all below it
  double fallen;    // the rung above: the lowest that makes it fall; 0: none did
  double share;     // of all rungs, those survived
};

bool Survives(const Ladder& ladder, double start_s, double impulse,
              std::vector<std::string> overrides) {
  char text[160];
  std::snprintf(text, sizeof text,
                "pushes=[{body: torso, force_N: [%.6f, 0, 0], start_s: %.4f, duration_s: %g}]",
                impulse * ladder.mass_kg / ladder.duration_s, start_s, ladder.duration_s);
  overrides.emplace_back(text);
  overrides.emplace_back("duration_s=" + std::to_string(start_s + ladder.duration_s + kAfter_s));
  overrides.emplace_back("expect={fall: false}");
  const ClosedLoopRun run(ladder.scenario, overrides);
  return run.verdict.verdict_class == VerdictClass::kPass;
}

Cell Climb(const Ladder& ladder, double start_s, double sign,
           const std::vector<std::string>& overrides) {
  Cell cell{0.0, 0.0, 0.0};
  for (int i = 1; i <= ladder.rungs; ++i) {
    const double impulse = ladder.rung * i;
    if (Survives(ladder, start_s, sign * impulse, overrides)) {
      cell.share += 1.0 / ladder.rungs;
      if (cell.fallen == 0.0) cell.survived = impulse;
    } else if (cell.fallen == 0.0) {
      cell.fallen = impulse;
    }
  }
  return cell;
}

// Prints each cell as survived<fallen share, and returns the mean of what is survived.
double MeanSurvived(const Ladder& ladder, const std::vector<std::string>& overrides) {
  double sum = 0.0, share = 0.0, least = ladder.rung * ladder.rungs;
  for (const double sign : {1.0, -1.0}) {
    std::printf("  %s, %g s, %s:", ladder.scenario.c_str(), ladder.duration_s,
                sign > 0.0 ? "forwards " : "backwards");
    for (int phase = 0; phase < kPhases; ++phase) {
      const double start_s = kFirstPush_s + ladder.step_s * phase / kPhases;
      const Cell cell = Climb(ladder, start_s, sign, overrides);
      std::printf(" %4.2f<%4.2f %3.0f%%", cell.survived, cell.fallen, 100.0 * cell.share);
      sum += cell.survived;
      share += cell.share;
      least = std::min(least, cell.survived);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  constexpr int kCells = 2 * kPhases;
  std::printf("  mean %.3f, least %.2f N s/kg, %.0f%% of the rungs\n", sum / kCells, least,
              100.0 * share / kCells);
  return sum / kCells;
}

class BipedPushesTest : public testing::TestWithParam<Ladder> {};

TEST_P(BipedPushesTest, StepAdjustmentIsWorthHalfAsMuchAgain) {
  const double with = MeanSurvived(GetParam(), {});
  const double without = MeanSurvived(GetParam(), kNoAdjustment);
  EXPECT_GT(with, 0.0);  // the point feet of rabbit can take nothing without
  EXPECT_GE(with, 1.5 * without);
}

std::string NameOf(const testing::TestParamInfo<Ladder>& info) {
  return info.param.scenario + "_" + std::to_string(std::lround(1e3 * info.param.duration_s)) +
         "_ms";
}

// The ladders end where nearly every cell has fallen.
INSTANTIATE_TEST_SUITE_P(Ladders, BipedPushesTest,
                         testing::Values(Ladder{"biped_walk", 1.0, 0.4, 0.1, 0.1, 20},
                                         Ladder{"biped_walk", 1.0, 0.4, 0.5, 0.2, 16},
                                         Ladder{"biped_run", 1.0, 0.3, 0.1, 0.2, 16},
                                         Ladder{"biped_run", 1.0, 0.3, 0.5, 0.4, 13},
                                         Ladder{"rabbit_walk_push", 40.0, 0.45, 0.1, 0.05, 20},
                                         Ladder{"rabbit_walk_push", 40.0, 0.45, 0.5, 0.1, 20}),
                         NameOf);

}  // namespace
}  // namespace sidestep
