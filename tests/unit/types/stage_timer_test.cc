// SPDX-License-Identifier: BSD-3-Clause
#include "controller/types/stage_timer.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/stage_log.h"

namespace sidestep::stage_timer_test {
namespace {

TEST(ScopedStageTest, BeginsAndEndsWithItsScope) {
  StageLog log;
  {
    const ScopedStage stage(&log, Stage::kMpc);
    EXPECT_EQ(log.events(), (std::vector<StageLog::Event>{{Stage::kMpc, true}}));
  }
  EXPECT_EQ(log.events(), StageLog::OneAfterAnother({Stage::kMpc}));
}

TEST(ScopedStageTest, AScopeWithinAnotherEndsFirst) {
  StageLog log;
  {
    const ScopedStage outer(&log, Stage::kPlanner);
    const ScopedStage inner(&log, Stage::kSwing);
  }
  const std::vector<StageLog::Event> nested{{Stage::kPlanner, true},
                                            {Stage::kSwing, true},
                                            {Stage::kSwing, false},
                                            {Stage::kPlanner, false}};
  EXPECT_EQ(log.events(), nested);
}

TEST(ScopedStageTest, EndsWhereAnExceptionLeavesTheScope) {
  StageLog log;
  try {
    const ScopedStage stage(&log, Stage::kWholeBody);
    throw std::runtime_error("in the middle");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(log.events(), StageLog::OneAfterAnother({Stage::kWholeBody}));
}

}  // namespace
}  // namespace sidestep::stage_timer_test
