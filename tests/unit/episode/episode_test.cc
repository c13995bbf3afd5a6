// SPDX-License-Identifier: BSD-3-Clause
#include "sim/episode/episode.h"

#include <gtest/gtest.h>

#include "models/support/config_error.h"
#include "sim/scenario/read_scenario.h"
#include "tests/unit/episode/episode_test_support.h"

namespace sidestep::episode_test {
namespace {

TEST(SetupOfTest, AControllerIsToldOfTheNominalRobotItsSettingsAndItsGait) {
  Scenario scenario = ShortHop(0.1, {"control.rate_hz=100", "world.step_s=0.002"});
  scenario.world.mass_scale = 1.3;  // the plant's secret
  const ControllerSetup setup = SetupOf(scenario);
  EXPECT_EQ(setup.robot.name, "hopper");
  EXPECT_EQ(setup.robot.file, scenario.robot.file);
  EXPECT_EQ(setup.robot.com_height_m, scenario.robot.com_height_m);
  ASSERT_EQ(setup.robot.feet.size(), 1u);
  EXPECT_EQ(setup.robot.mass_kg, scenario.robot.mass_kg) << "unscaled";
  EXPECT_EQ(setup.control.rate_hz, 100.0);
  EXPECT_EQ(setup.control.mode, ControlMode::kTorque);
  ASSERT_EQ(setup.gait.size(), 3u) << "as scenarios/hopper_hop.yaml has them";
  EXPECT_EQ(setup.gait[0].start_s, 0.0);
  EXPECT_EQ(setup.gait[1].start_s, 0.5);
  EXPECT_FALSE(setup.is_centroidal);
  EXPECT_EQ(setup.tick_s, 0.002);
}

TEST(SetupOfTest, TheCentroidalPlantIsToldApart) {
  Scenario scenario;
  EXPECT_FALSE(SetupOf(scenario).is_centroidal);
  scenario.plant = Plant::kCentroidal;
  EXPECT_TRUE(SetupOf(scenario).is_centroidal);
}

TEST(StartEpisodeTest, TheFactoryIsCalledOnceWithTheSetupAndTheEpisodesOwnTimer) {
  const Scenario scenario = ShortHop(0.1, {"control.rate_hz=100"});
  int num_calls = 0;
  StageTimer* told = nullptr;
  const Episode episode =
      StartEpisode(scenario, [&](const ControllerSetup& setup, StageTimer* timer) {
        ++num_calls;
        told = timer;
        EXPECT_EQ(setup.control.rate_hz, 100.0);
        return std::make_unique<TorqueController>(NoTorque, nullptr);
      });
  EXPECT_EQ(num_calls, 1);
  EXPECT_EQ(told, episode.timer.get());
  EXPECT_EQ(episode.tick, 0);
  EXPECT_EQ(episode.time_s(), 0.0);
  EXPECT_FALSE(episode.is_over);
  EXPECT_FALSE(episode.judge.finished());
}

TEST(StartEpisodeTest, TimeIsTicksOfTheScenariosOwnLength) {
  Episode episode = StartEpisode(ShortHop(0.1, {"world.step_s=0.002"}), TorqueBy(NoTorque));
  RunEpisode(&episode, {}, 17);
  EXPECT_EQ(episode.tick, 17);
  EXPECT_DOUBLE_EQ(episode.time_s(), 0.034);
}

TEST(StartEpisodeTest, APushOnABodyThatTheRobotLacksIsAMistakeOfTheUser) {
  Scenario scenario = ShortHop(0.1);
  scenario.pushes = {TrunkPush({1.0, 0.0, 0.0}, 0.0, 0.1, Eigen::Vector3d::Zero())};
  EXPECT_NO_THROW(StartEpisode(scenario, TorqueBy(NoTorque)));
  scenario.pushes[0].body = "tail";
  try {
    StartEpisode(scenario, TorqueBy(NoTorque));
    ADD_FAILURE() << "a hopper has no tail";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("tail"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sidestep::episode_test
