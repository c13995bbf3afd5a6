// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/wall_stage_timer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace sidestep::wall_stage_timer_test {
namespace {

// sleep_for never wakes early on the steady clock, so the bounds from below are exact; from above
// only zero is.
void SleepIn(WallStageTimer* timer, Stage stage, int sleep_ms) {
  const ScopedStage scope(timer, stage);
  std::this_thread::sleep_for(std::chrono::milliseconds(sleep_ms));
}

TEST(WallStageTimerTest, AStageThatDidNotRunTookExactlyNothing) {
  const WallStageTimer timer;
  for (int stage = 0; stage < static_cast<int>(Stage::kCount); ++stage) {
    EXPECT_EQ(timer.Spent_ms(static_cast<Stage>(stage)), 0.0) << stage;
  }
}

TEST(WallStageTimerTest, RunsOfAStageAddUpAndOtherStagesKeepOutOfIt) {
  WallStageTimer timer;
  SleepIn(&timer, Stage::kMpc, 3);
  const double once_ms = timer.Spent_ms(Stage::kMpc);
  EXPECT_GE(once_ms, 3.0);
  SleepIn(&timer, Stage::kWholeBody, 2);
  EXPECT_EQ(timer.Spent_ms(Stage::kMpc), once_ms) << "the other stage's time is not its own";
  SleepIn(&timer, Stage::kMpc, 3);
  EXPECT_GE(timer.Spent_ms(Stage::kMpc), once_ms + 3.0);
  EXPECT_GE(timer.Spent_ms(Stage::kWholeBody), 2.0);
  EXPECT_EQ(timer.Spent_ms(Stage::kSwing), 0.0);
}

TEST(WallStageTimerTest, AStageInsideAnotherCountsForBoth) {
  WallStageTimer timer;
  {
    const ScopedStage outer(&timer, Stage::kPlanner);
    SleepIn(&timer, Stage::kMpc, 2);
  }
  EXPECT_GE(timer.Spent_ms(Stage::kMpc), 2.0);
  EXPECT_GE(timer.Spent_ms(Stage::kPlanner), timer.Spent_ms(Stage::kMpc));
}

TEST(WallStageTimerTest, WhatHasNotEndedIsNotYetCounted) {
  WallStageTimer timer;
  timer.Begin(Stage::kSwing);
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(timer.Spent_ms(Stage::kSwing), 0.0);
  timer.End(Stage::kSwing);
  EXPECT_GE(timer.Spent_ms(Stage::kSwing), 1.0);
}

TEST(WallStageTimerTest, ResetForgetsEveryStage) {
  WallStageTimer timer;
  SleepIn(&timer, Stage::kEstimator, 1);
  SleepIn(&timer, Stage::kWholeBody, 1);
  timer.Reset();
  EXPECT_EQ(timer.Spent_ms(Stage::kEstimator), 0.0);
  EXPECT_EQ(timer.Spent_ms(Stage::kWholeBody), 0.0);
  SleepIn(&timer, Stage::kEstimator, 1);
  EXPECT_GE(timer.Spent_ms(Stage::kEstimator), 1.0) << "it can be used again";
}

}  // namespace
}  // namespace sidestep::wall_stage_timer_test
