// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/timing_candidates.h"

#include <algorithm>

#include "controller/planner/gait_writer.h"
#include "controller/planner/schedule_edits.h"
#include "controller/planner/step_ahead.h"

namespace sidestep {
namespace {

constexpr int kStepsFromStanding = 4;  // two to catch the robot, two to close up

bool StandsStill(const GaitSetup& setup, const GaitSupport& support) {
  const GaitWriter writer(setup, support, nullptr);
  return writer.NextGait().type == GaitType::kStand && writer.FeetSideBySide();
}

// As the gait, but off the ground at once and in the air for `swing` ticks.
GaitParams Quick(const GaitSetup& setup, GaitParams gait, const TimingLimits& limits, Tick swing) {
  gait.swing_s = SecondsAt(swing, setup.tick_s);
  gait.double_support_s = SecondsAt(limits.least_support, setup.tick_s);
  return gait;
}

// On both feet: either foot may lift off at once, for as long as the gait has it or less.
void ListLiftOffs(const GaitSetup& setup, const GaitSupport& support, Tick now,
                  const StepAhead& step, const TimingLimits& limits,
                  std::vector<GaitSupport>* candidates) {
  const Tick swing = TickAt(step.gait.swing_s, setup.tick_s);
  const Tick quickest = std::min(swing, limits.least_swing);
  for (const int foot : {step.foot, 1 - step.foot}) {
    for (const Tick time : {swing, quickest}) {
      const GaitParams gait = Quick(setup, step.gait, limits, time);
      auto lifted =
          StepOnTheSpot(setup, support, now, {1, gait.swing_s, gait.double_support_s, foot});
      if (!lifted) continue;
      lifted->orders.next[0].gait = gait;
      candidates->push_back(*lifted);
      if (swing == quickest) break;
    }
  }
}

// Standing: either foot may step out at once, and the feet follow each other until they stand
// again.
void ListSteps(const GaitSetup& setup, const GaitSupport& support, Tick now,
               const TimingLimits& limits, std::vector<GaitSupport>* candidates) {
  const double support_s = SecondsAt(limits.least_support, setup.tick_s);
  const double swing_s = SecondsAt(limits.least_swing, setup.tick_s);
  for (const int foot : {0, 1}) {
    const auto steps =
        StepOnTheSpot(setup, support, now, {kStepsFromStanding, swing_s, support_s, foot});
    if (steps) candidates->push_back(*steps);
  }
}

// One foot in the air: it may land sooner, and be followed quickly by the other one, or itself.
void ListLandings(const GaitSetup& setup, const GaitSupport& support, Tick now,
                  const StepAhead& step, const TimingLimits& limits,
                  std::vector<GaitSupport>* candidates) {
  const Tick quickest = std::min(TickAt(step.gait.swing_s, setup.tick_s), limits.least_swing);
  const GaitParams quick = Quick(setup, step.gait, limits, quickest);
  for (Tick by = 0; step.landing - by >= now + limits.least_rest; by += limits.step) {
    GaitSupport landed = support;
    if (by > 0) {
      const TouchDownMove sooner{support.sequence + 1, -by};
      const auto moved = MoveTouchDown(setup, support, now, sooner, limits.least_rest);
      if (!moved) return;
      landed = *moved;
      candidates->push_back(landed);
    }
    landed.orders.next[0] = {step.gait, 1, -1};
    for (const int foot : {1 - step.foot, step.foot}) {
      landed.orders.next[1] = {quick, 1, foot};
      candidates->push_back(landed);
    }
  }
}

}  // namespace

// Each landing by the clock or sooner: as it is, followed by the other foot, followed by itself.
std::size_t MostTimingCandidates(const GaitSetup& setup, const TimingLimits& limits) {
  constexpr Tick kCoursesALanding = 3, kLiftOffs = 4;
  Tick longest = limits.least_swing;
  for (const GaitParams& gait : setup.segments) {
    longest = std::max(longest, TickAt(gait.swing_s, setup.tick_s));
  }
  return static_cast<std::size_t>(
      std::max(kLiftOffs, kCoursesALanding * (longest / limits.step + 1)));
}

void ListTimingCandidates(const GaitSetup& setup, const GaitSupport& support, Tick now,
                          const TimingLimits& limits, std::vector<GaitSupport>* candidates) {
  candidates->clear();
  if (setup.geometry.num_feet != 2) return;
  if (StandsStill(setup, support)) {
    ListSteps(setup, support, now, limits, candidates);
    return;
  }
  const auto step = StepAheadOf(setup, support);
  if (!step || step->gait.type != GaitType::kWalk || step->landing <= now) return;
  if (step->lift_off > now) {
    ListLiftOffs(setup, support, now, *step, limits, candidates);
  } else {
    ListLandings(setup, support, now, *step, limits, candidates);
  }
}

}  // namespace sidestep
