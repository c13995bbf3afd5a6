// SPDX-License-Identifier: BSD-3-Clause
// The loop itself: where it stops, whom it asks, when, and what it tells them.

#include "sim/episode/run_episode.h"

#include <gtest/gtest.h>

#include "sim/sensors/sensor_suite.h"
#include "tests/unit/episode/episode_test_support.h"

namespace sidestep::run_episode_test {
namespace {

constexpr Tick kEnd = 160;             // ticks of 1 ms
constexpr double kDuration_s = 0.160;  // the same

std::string BitsAtEnd(const Scenario& scenario, const ControllerFactory& make,
                      const std::vector<Tick>& stops) {
  Episode episode = StartEpisode(scenario, make);
  for (const Tick stop : stops) {
    RunEpisode(&episode, {}, stop);
    EXPECT_EQ(episode.tick, stop);
    EXPECT_FALSE(episode.is_over) << "stopped at " << stop;
  }
  RunEpisode(&episode, {});
  EXPECT_TRUE(episode.is_over);
  EXPECT_EQ(episode.tick, kEnd);
  return BitsOf(episode.world->truth());
}

TEST(RunEpisodeTest, ItStopsAtUntilAndGoesOnAsIfItHadNot) {
  const Scenario scenario = ShortHop(kDuration_s);
  const ControllerFactory make = TorqueBy(NoisyTorque);
  const std::string straight = BitsAtEnd(scenario, make, {});
  EXPECT_EQ(BitsAtEnd(scenario, make, {1, 2, 77, 100, 159}), straight) << "odd ticks ask nobody";
  Scenario other = scenario;
  other.seed = 2;
  EXPECT_NE(BitsAtEnd(other, make, {}), straight) << "other noise must show in the bits";
}

TEST(RunEpisodeTest, TheShippedControllerGoesOnAsIfItHadNotStopped) {
  const Scenario scenario = ShortHop(kDuration_s);
  EXPECT_EQ(BitsAtEnd(scenario, MakeController, {51, 101}),
            BitsAtEnd(scenario, MakeController, {}));
}

TEST(RunEpisodeTest, UntilATickThatIsDoneDoesNothing) {
  auto seen = std::make_shared<Frames>();
  Episode episode = StartEpisode(ShortHop(kDuration_s), TorqueBy(NoTorque, seen));
  RunEpisode(&episode, {}, 0);
  EXPECT_EQ(seen->size(), 0u) << "tick 0 itself comes after `until` 0";
  RunEpisode(&episode, {}, 40);
  ASSERT_EQ(seen->size(), 20u);
  const std::string bits = BitsOf(episode.world->truth());
  for (const Tick until : {Tick{40}, Tick{39}, Tick{0}, Tick{-1}}) {
    RunEpisode(&episode, {}, until);
    EXPECT_EQ(episode.tick, 40);
    EXPECT_EQ(seen->size(), 20u);
    EXPECT_EQ(BitsOf(episode.world->truth()), bits);
  }
}

TEST(RunEpisodeTest, TheControllerOfTheFactoryIsAskedOnceAControlPeriodInOrder) {
  const struct {
    const char* rate;
    Tick period;
  } rates[] = {{"control.rate_hz=500", 2}, {"control.rate_hz=200", 5}};
  for (const auto& [rate, period] : rates) {
    auto seen = std::make_shared<Frames>();
    Episode episode = StartEpisode(ShortHop(kDuration_s, {rate}), TorqueBy(NoTorque, seen));
    RunEpisode(&episode, {});
    ASSERT_EQ(seen->size(), static_cast<std::size_t>(kEnd / period + 1)) << rate << ": 0 and end";
    for (std::size_t i = 0; i < seen->size(); ++i) {
      EXPECT_EQ((*seen)[i].tick, static_cast<Tick>(i) * period) << rate;
    }
  }
}

TEST(RunEpisodeTest, ACommandActsFromItsTickUntilTheNextOne) {
  // Full thrust of the leg is asked for once, at tick 10; the motor shows it in the two steps of
  // its period, which lead to ticks 11 and 12.
  const auto law = [](const SensorFrame& frame, int) {
    Eigen::VectorXd torque_Nm = Eigen::VectorXd::Zero(frame.joint_position.size());
    if (frame.tick == 10) torque_Nm[2] = 1.5;
    return torque_Nm;
  };
  Episode episode = StartEpisode(ShortHop(kDuration_s), TorqueBy(law));
  std::vector<Tick> thrusts;
  while (episode.tick < 20) {
    RunEpisode(&episode, {}, episode.tick + 1);
    const double thrust_N = episode.world->truth().joint_torque_Nm[2];
    if (thrust_N != 0.0) {
      EXPECT_EQ(thrust_N, 1.5);
      thrusts.push_back(episode.tick);
    }
  }
  EXPECT_EQ(thrusts, (std::vector<Tick>{11, 12}));
}

TEST(RunEpisodeTest, FramesCarryNoTruthUnlessTheScenarioPermitsIt) {
  Scenario scenario = ShortHop(kDuration_s);
  scenario.pushes = {TrunkPush({0.0, 3.0, 0.0}, 0.1, 0.02, Eigen::Vector3d::Zero())};
  auto seen = std::make_shared<Frames>();
  Episode episode = StartEpisode(scenario, TorqueBy(NoTorque, seen));
  RunEpisode(&episode, {});
  ASSERT_EQ(seen->size(), 81u);
  for (const SensorFrame& frame : *seen) {
    EXPECT_FALSE(frame.truth.has_value());
    EXPECT_FALSE(frame.centroidal.has_value());
    EXPECT_FALSE(frame.known_external_wrench.has_value());
  }
}

TEST(RunEpisodeTest, PermittedTruthIsTheWorldsOfThatTick) {
  Scenario scenario =
      ShortHop(kDuration_s, {"control.estimator=truth", "control.external_wrench=known"});
  scenario.pushes = {TrunkPush({0.0, 3.0, 0.0}, 0.1, 0.02, Eigen::Vector3d::Zero())};
  auto seen = std::make_shared<Frames>();
  Episode episode = StartEpisode(scenario, TorqueBy(NoTorque, seen));
  for (Tick tick = 0; tick < kEnd; tick += 2) {
    RunEpisode(&episode, {}, tick);
    const WorldTruth truth = episode.world->truth();
    RunEpisode(&episode, {}, tick + 1);
    const SensorFrame& frame = seen->back();
    ASSERT_EQ(frame.tick, tick);
    ASSERT_TRUE(frame.truth.has_value());
    EXPECT_EQ(frame.truth->p_WB, truth.p_WB) << tick;
    EXPECT_EQ(frame.truth->v_WB, truth.v_WB) << tick;
    ASSERT_TRUE(frame.known_external_wrench.has_value());
    const bool acts = tick >= 100 && tick < 120;
    EXPECT_EQ(frame.known_external_wrench->force_N, Eigen::Vector3d(0.0, acts ? 3.0 : 0.0, 0.0))
        << tick;
  }
}

}  // namespace
}  // namespace sidestep::run_episode_test
