// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/step_ahead.h"

#include <gtest/gtest.h>

#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::step_ahead_test {
namespace {

// Feet leave 0.2 s after the last landing and are 0.6 s in the air; the walk begins at 1 s, as if
// one had landed.
GaitSetup StandAndWalk() {
  return SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 1.0)}, 2);
}

TEST(StepAheadTest, FirstStepIsToldByHand) {
  const GaitSetup setup = StandAndWalk();
  const auto step = StepAheadOf(setup, SupportAt(setup, 1000));
  ASSERT_TRUE(step.has_value());
  EXPECT_EQ(step->lift_off, 1200);
  EXPECT_EQ(step->landing, 1800);
  EXPECT_EQ(step->gait.type, GaitType::kWalk);
}

TEST(StepAheadTest, ThereIsNoneFromAStandThatEndsByTheClockOrNever) {
  const GaitSetup setup = StandAndWalk();
  EXPECT_FALSE(StepAheadOf(setup, SupportAt(setup, 500)).has_value());
  const GaitSetup still = SetupOf({Stretch(GaitType::kStand, 0.0)}, 2);
  EXPECT_FALSE(StepAheadOf(still, SupportAt(still, 500)).has_value());
}

// By another way: what the next support says of its newest foot.
TEST(StepAheadTest, ItIsTheStepThatTheNextSupportHasMade) {
  const GaitSetup setup = SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 0.5),
                                   Stretch(GaitType::kRun, 2.0), Stretch(GaitType::kStand, 4.0)},
                                  2);
  int steps = 0;
  GaitSupport support = StandingSupport(setup);
  int last_foot = -1;
  GaitType last_gait = GaitType::kStand;
  while (const auto next = NextSupport(setup, support)) {
    const auto step = StepAheadOf(setup, support);
    ASSERT_EQ(step.has_value(), next->sequence > support.sequence) << support.tick;
    if (step) {
      ++steps;
      EXPECT_EQ(step->landing, next->tick);
      const auto foot = static_cast<std::size_t>(step->foot);
      EXPECT_EQ(next->feet[foot].nominal.sequence, next->sequence);
      EXPECT_NE(step->foot, last_foot) << "feet take turns";
      last_foot = step->foot;
      EXPECT_LT(step->lift_off, step->landing);
      last_gait = step->gait.type;
    }
    support = *next;
  }
  EXPECT_GT(steps, 7);
  EXPECT_EQ(last_gait, GaitType::kStand) << "the step that closes up is the stand's";
  EXPECT_FALSE(StepAheadOf(setup, support).has_value()) << "it stands";
}

TEST(StepAheadTest, AFootInTheAirHasLeft) {
  const GaitSetup setup =
      SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kRun, 1.0)}, 2);
  const GaitSupport support = SupportAt(setup, 3000);
  const auto step = StepAheadOf(setup, support);
  ASSERT_TRUE(step.has_value());
  const auto foot = static_cast<std::size_t>(step->foot);
  EXPECT_LE(step->lift_off, support.tick) << "a run's swing begins before the other foot lands";
  EXPECT_EQ(step->lift_off, support.feet[foot].nominal.contact.end_tick);
}

}  // namespace
}  // namespace sidestep::step_ahead_test
