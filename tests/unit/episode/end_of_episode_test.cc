// SPDX-License-Identifier: BSD-3-Clause
// How a run ends: by its duration, by a fall, by a world that diverged; and that it stays ended.

#include <gtest/gtest.h>

#include <limits>

#include "sim/episode/run_episode.h"
#include "tests/unit/episode/episode_test_support.h"

namespace sidestep::end_of_episode_test {
namespace {

constexpr Tick kAfterFall = 500;  // ticks of 1 ms: half a second, so that a video shows the fall

Verdict VerdictOf(const Episode& episode) { return episode.judge.Conclude().verdict; }

bool HasFallen(const Episode& episode) {
  return std::get<bool>(episode.judge.Conclude().metrics.at("fall"));
}

TEST(EndOfEpisodeTest, TheLastTickOfTheDurationIsJudgedAndNothingFollowsIt) {
  auto seen = std::make_shared<Frames>();
  Episode episode = StartEpisode(ShortHop(0.05), TorqueBy(NoTorque, seen));
  RunEpisode(&episode, {}, 50);
  EXPECT_FALSE(episode.is_over) << "tick 50 is still to come";
  EXPECT_EQ(seen->back().tick, 48);
  RunEpisode(&episode, {});
  EXPECT_TRUE(episode.is_over);
  EXPECT_EQ(episode.tick, 50);
  EXPECT_DOUBLE_EQ(episode.time_s(), 0.05);
  EXPECT_EQ(seen->back().tick, 50);
  EXPECT_EQ(VerdictOf(episode).verdict_class, VerdictClass::kPass);

  const std::string bits = BitsOf(episode.world->truth());
  RunEpisode(&episode, {}, 1000);
  EXPECT_EQ(episode.tick, 50);
  EXPECT_EQ(seen->back().tick, 50) << "a run that is over asks nobody";
  EXPECT_EQ(BitsOf(episode.world->truth()), bits);
}

TEST(EndOfEpisodeTest, AFallEndsItHalfASecondLater) {
  Episode episode = StartEpisode(FallingHopper(), TorqueBy(NoTorque));
  while (!HasFallen(episode)) {
    ASSERT_FALSE(episode.is_over) << "it was to fall";
    RunEpisode(&episode, {}, episode.tick + 1);
  }
  const Tick fall = episode.tick - 1;  // the last tick that was judged
  EXPECT_GT(fall, 100) << "not before the push";
  EXPECT_FALSE(episode.is_over);
  RunEpisode(&episode, {});
  EXPECT_TRUE(episode.is_over);
  EXPECT_EQ(episode.tick, fall + kAfterFall);
  EXPECT_LT(episode.time_s(), episode.scenario.duration_s);
  const Verdict verdict = VerdictOf(episode);
  EXPECT_EQ(verdict.verdict_class, VerdictClass::kFail);
  ASSERT_FALSE(verdict.reasons.empty());
  EXPECT_EQ(verdict.reasons[0].kind, reason::kFall);
  EXPECT_DOUBLE_EQ(verdict.reasons[0].time_s.value(), 0.001 * static_cast<double>(fall));
}

TEST(EndOfEpisodeTest, AFallNearTheEndDoesNotLengthenTheRun) {
  Scenario scenario = FallingHopper();
  Episode first = StartEpisode(scenario, TorqueBy(NoTorque));
  while (!HasFallen(first) && !first.is_over) RunEpisode(&first, {}, first.tick + 1);
  scenario.duration_s = first.time_s() + 0.1;
  Episode second = StartEpisode(scenario, TorqueBy(NoTorque));
  RunEpisode(&second, {});
  EXPECT_TRUE(HasFallen(second));
  EXPECT_EQ(second.tick, TickAt(scenario.duration_s, 0.001));
}

// Commands `torque_Nm` from tick 20 on, and nothing before.
TorqueController::Law FromTick20(double torque_Nm) {
  return [torque_Nm](const SensorFrame& frame, int) {
    return Eigen::VectorXd::Constant(frame.joint_position.size(),
                                     frame.tick < 20 ? 0.0 : torque_Nm);
  };
}

TEST(EndOfEpisodeTest, AControllerThatCommandsNanMakesTheRunInvalidAtOnce) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Episode episode = StartEpisode(ShortHop(0.5), TorqueBy(FromTick20(nan)));
  RunEpisode(&episode, {});
  EXPECT_TRUE(episode.is_over);
  EXPECT_EQ(episode.tick, 21) << "the one step under that command";
  EXPECT_FALSE(episode.world->is_valid());
  const Verdict verdict = VerdictOf(episode);
  EXPECT_EQ(verdict.verdict_class, VerdictClass::kInvalid) << "it is no FAIL";
  ASSERT_FALSE(verdict.reasons.empty());
  for (const Reason& reason : verdict.reasons) EXPECT_EQ(reason.kind, reason::kDiverged);
  EXPECT_DOUBLE_EQ(verdict.reasons[0].time_s.value(), 0.021);
}

TEST(EndOfEpisodeTest, ATorqueBeyondReasonMeetsTheMotorsLimitAndLeavesTheRunValid) {
  Episode episode = StartEpisode(ShortHop(0.1), TorqueBy(FromTick20(1e30)));
  RunEpisode(&episode, {});
  EXPECT_EQ(episode.tick, 100);
  EXPECT_TRUE(episode.world->is_valid());
  EXPECT_NE(VerdictOf(episode).verdict_class, VerdictClass::kInvalid);
  EXPECT_EQ(episode.world->truth().num_saturated, 3) << "all three motors of the hopper";
}

}  // namespace
}  // namespace sidestep::end_of_episode_test
