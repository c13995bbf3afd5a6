// SPDX-License-Identifier: BSD-3-Clause
// A fork goes on as its original would, and nothing that happens to the one shows in the other.

#include <gtest/gtest.h>

#include "sim/episode/run_episode.h"
#include "tests/unit/episode/episode_test_support.h"

namespace sidestep::fork_episode_test {
namespace {

constexpr double kDuration_s = 0.2;
constexpr Tick kFork = 75;  // odd: a fork between two control ticks keeps the command in force

std::string BitsAtEnd(Episode* episode) {
  RunEpisode(episode, {});
  EXPECT_EQ(episode->tick, 200);
  return BitsOf(episode->world->truth());
}

// At tick kFork, under a controller whose count and whose noise decide what it commands.
Episode HalfWay() {
  Episode episode = StartEpisode(ShortHop(kDuration_s), TorqueBy(NoisyTorque));
  RunEpisode(&episode, {}, kFork);
  return episode;
}

TEST(ForkEpisodeTest, AForkStandsWhereItsOriginalDoesAndOwnsItsParts) {
  const Episode original = HalfWay();
  const Episode fork = Fork(original);
  EXPECT_EQ(fork.tick, kFork);
  EXPECT_FALSE(fork.is_over);
  EXPECT_EQ(BitsOf(fork.world->truth()), BitsOf(original.world->truth()));
  EXPECT_NE(fork.world, original.world);
  EXPECT_NE(fork.timer, original.timer);
  EXPECT_NE(fork.controller, original.controller);
}

TEST(ForkEpisodeTest, BothGoOnAsTheStraightRunWhicheverGoesFirst) {
  Episode straight = StartEpisode(ShortHop(kDuration_s), TorqueBy(NoisyTorque));
  const std::string bits = BitsAtEnd(&straight);
  Episode original = HalfWay();
  Episode early = Fork(original);
  EXPECT_EQ(BitsAtEnd(&early), bits);
  EXPECT_EQ(original.tick, kFork) << "the fork's run moved its original";
  Episode late = Fork(original);
  EXPECT_EQ(BitsAtEnd(&original), bits);
  EXPECT_EQ(late.tick, kFork);
  EXPECT_EQ(BitsAtEnd(&late), bits);
}

TEST(ForkEpisodeTest, AForkUnderAnotherControllerGoesItsOwnWayAlone) {
  Episode original = HalfWay();
  Episode fork = Fork(original);
  // The same law that has forgotten how often it was asked: the count is part of the state.
  fork.controller = std::make_unique<TorqueController>(NoisyTorque, nullptr);
  const std::string forgetful = BitsAtEnd(&fork);
  const std::string remembering = BitsAtEnd(&original);
  EXPECT_NE(forgetful, remembering);
  Episode straight = StartEpisode(ShortHop(kDuration_s), TorqueBy(NoisyTorque));
  EXPECT_EQ(BitsAtEnd(&straight), remembering);
}

TEST(ForkEpisodeTest, AVerdictOnTheForkIsNoneOnItsOriginal) {
  Episode original = HalfWay();
  Episode fork = Fork(original);
  fork.judge.Invalidate(reason::kError, "of the fork alone", 0.1);
  EXPECT_TRUE(fork.judge.finished());
  EXPECT_FALSE(original.judge.finished());
  RunEpisode(&fork, {});
  EXPECT_TRUE(fork.is_over);
  EXPECT_EQ(fork.tick, kFork) << "nothing is left to learn from it";
  BitsAtEnd(&original);
  EXPECT_EQ(original.judge.Conclude().verdict.verdict_class, VerdictClass::kPass);
  EXPECT_EQ(fork.judge.Conclude().verdict.verdict_class, VerdictClass::kInvalid);
}

TEST(ForkEpisodeTest, AForkOfARunThatIsOverIsOver) {
  Episode original = HalfWay();
  const std::string bits = BitsAtEnd(&original);
  Episode fork = Fork(original);
  EXPECT_TRUE(fork.is_over);
  EXPECT_EQ(BitsAtEnd(&fork), bits);
}

// Spends its time in the MPC's stage, and tells whose clock it was given.
class TimedController final : public Controller {
 public:
  explicit TimedController(StageTimer* timer) : timer_(timer) {}

  const ControlTick& Update(const SensorFrame& frame) override {
    const ScopedStage stage(timer_, Stage::kMpc);
    tick_.tick = frame.tick;
    tick_.command.torque_Nm.setZero(frame.joint_position.size());
    return tick_;
  }
  std::unique_ptr<Controller> Clone(StageTimer* timer) const override {
    auto copy = std::make_unique<TimedController>(*this);
    copy->timer_ = timer;
    return copy;
  }

 private:
  StageTimer* timer_;
  ControlTick tick_;
};

TEST(ForkEpisodeTest, AForksControllerReportsToTheForksTimer) {
  Episode original =
      StartEpisode(ShortHop(kDuration_s), [](const ControllerSetup&, StageTimer* timer) {
        return std::make_unique<TimedController>(timer);
      });
  RunEpisode(&original, {}, kFork);
  EXPECT_GT(original.timer->Spent(Stage::kMpc).wall_ms, 0.0);
  original.timer->Reset();
  Episode fork = Fork(original);
  EXPECT_EQ(fork.timer->Spent(Stage::kMpc).wall_ms, 0.0);
  RunEpisode(&fork, {}, kFork + 10);
  EXPECT_GT(fork.timer->Spent(Stage::kMpc).wall_ms, 0.0);
  EXPECT_EQ(original.timer->Spent(Stage::kMpc).wall_ms, 0.0);
}

}  // namespace
}  // namespace sidestep::fork_episode_test
