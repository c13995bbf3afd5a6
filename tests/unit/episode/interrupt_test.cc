// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/interrupt.h"

#include <gtest/gtest.h>

#include "tests/unit/episode/episode_test_support.h"

namespace sidestep::interrupted_episode_test {
namespace {

// Leaves the program as interruptible as it was found.
class InterruptTest : public ::testing::Test {
 protected:
  ~InterruptTest() override {
    internal::interrupt_flag = false;
    internal::interrupt_time_s = 0;
  }
};

TEST_F(InterruptTest, ARunEndsAfterTheTickInHandAndIsInvalid) {
  auto seen = std::make_shared<Frames>();
  const auto law = [](const SensorFrame& frame, int num_before) {
    if (frame.tick == 30) internal::HandleInterrupt(SIGINT);
    return NoTorque(frame, num_before);
  };
  Episode episode = StartEpisode(ShortHop(0.2), TorqueBy(law, seen));
  RunEpisode(&episode, {});
  EXPECT_TRUE(episode.is_over);
  EXPECT_EQ(episode.tick, 30);
  EXPECT_EQ(seen->back().tick, 30);
  const Verdict verdict = episode.judge.Conclude().verdict;
  EXPECT_EQ(verdict.verdict_class, VerdictClass::kInvalid);
  ASSERT_EQ(verdict.reasons.size(), 1u);
  EXPECT_EQ(verdict.reasons[0].kind, reason::kInterrupted);
  EXPECT_DOUBLE_EQ(verdict.reasons[0].time_s.value(), 0.03);
}

}  // namespace
}  // namespace sidestep::interrupted_episode_test
