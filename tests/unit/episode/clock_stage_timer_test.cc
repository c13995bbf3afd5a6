// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/clock_stage_timer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <thread>

namespace sidestep::clock_stage_timer_test {
namespace {

// sleep_for never wakes early on the steady clock, so the bounds from below are exact; from above
// only zero is.
void SleepIn(ClockStageTimer* timer, Stage stage, int sleep_ms) {
  const ScopedStage scope(timer, stage);
  std::this_thread::sleep_for(std::chrono::milliseconds(sleep_ms));
}

TEST(ClockStageTimerTest, AStageThatDidNotRunTookExactlyNothing) {
  const ClockStageTimer timer;
  for (int stage = 0; stage < static_cast<int>(Stage::kCount); ++stage) {
    EXPECT_EQ(timer.Spent(static_cast<Stage>(stage)).wall_ms, 0.0) << stage;
  }
}

TEST(ClockStageTimerTest, RunsOfAStageAddUpAndOtherStagesKeepOutOfIt) {
  ClockStageTimer timer;
  SleepIn(&timer, Stage::kMpc, 3);
  const double once_ms = timer.Spent(Stage::kMpc).wall_ms;
  EXPECT_GE(once_ms, 3.0);
  SleepIn(&timer, Stage::kWholeBody, 2);
  EXPECT_EQ(timer.Spent(Stage::kMpc).wall_ms, once_ms) << "the other stage's time is not its own";
  SleepIn(&timer, Stage::kMpc, 3);
  EXPECT_GE(timer.Spent(Stage::kMpc).wall_ms, once_ms + 3.0);
  EXPECT_GE(timer.Spent(Stage::kWholeBody).wall_ms, 2.0);
  EXPECT_EQ(timer.Spent(Stage::kSwing).wall_ms, 0.0);
}

TEST(ClockStageTimerTest, TheProcessorsTimeIsOfWorkAndNotOfSleep) {
  ClockStageTimer timer;
  SleepIn(&timer, Stage::kMpc, 50);
  EXPECT_LT(timer.Spent(Stage::kMpc).cpu_ms, 25.0);
  timer.Begin(Stage::kSwing);
  const std::clock_t start = std::clock();  // the process', of which this thread is all
  while (std::clock() - start < CLOCKS_PER_SEC / 50) {
  }
  timer.End(Stage::kSwing);
  EXPECT_GE(timer.Spent(Stage::kSwing).cpu_ms, 15.0);
  EXPECT_LE(timer.Spent(Stage::kSwing).cpu_ms, timer.Spent(Stage::kSwing).wall_ms + 1.0);
}

TEST(ClockStageTimerTest, AStageInsideAnotherCountsForBoth) {
  ClockStageTimer timer;
  {
    const ScopedStage outer(&timer, Stage::kPlanner);
    SleepIn(&timer, Stage::kMpc, 2);
  }
  EXPECT_GE(timer.Spent(Stage::kMpc).wall_ms, 2.0);
  EXPECT_GE(timer.Spent(Stage::kPlanner).wall_ms, timer.Spent(Stage::kMpc).wall_ms);
}

TEST(ClockStageTimerTest, WhatHasNotEndedIsNotYetCounted) {
  ClockStageTimer timer;
  timer.Begin(Stage::kSwing);
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(timer.Spent(Stage::kSwing).wall_ms, 0.0);
  timer.End(Stage::kSwing);
  EXPECT_GE(timer.Spent(Stage::kSwing).wall_ms, 1.0);
}

TEST(ClockStageTimerTest, ResetForgetsEveryStage) {
  ClockStageTimer timer;
  SleepIn(&timer, Stage::kEstimator, 1);
  SleepIn(&timer, Stage::kWholeBody, 1);
  timer.Reset();
  EXPECT_EQ(timer.Spent(Stage::kEstimator).wall_ms, 0.0);
  EXPECT_EQ(timer.Spent(Stage::kWholeBody).wall_ms, 0.0);
  SleepIn(&timer, Stage::kEstimator, 1);
  EXPECT_GE(timer.Spent(Stage::kEstimator).wall_ms, 1.0) << "it can be used again";
}

}  // namespace
}  // namespace sidestep::clock_stage_timer_test
