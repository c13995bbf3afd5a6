// SPDX-License-Identifier: BSD-3-Clause
// A run forked in its middle and the straight run are one run, bit for bit, for every scenario that
// ships; and a controller that hides state from its copies is found out.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "models/support/require.h"
#include "sim/episode/run_episode.h"
#include "sim/record/run_summary.h"
#include "sim/scenario/read_scenario.h"
#include "tests/support/run_files.h"
#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

constexpr Tick kSlice = 333;  // ticks that one goes on before the other's turn

std::vector<std::string> ShippedNames() {
  std::vector<std::string> names;
  const std::filesystem::path folder = std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  return names;
}

Scenario Shipped(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return ReadScenario(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios" / (name + ".yaml"),
                      overrides);
}

// summary.json without what a clock wrote.
std::string SummaryText(const std::filesystem::path& run_dir) {
  RunSummary summary = ReadSummary(run_dir);
  summary.solve_time = summary.whole_body_time = {};
  summary.solve_cpu = summary.whole_body_cpu = {};
  summary.wall_s = summary.real_time_factor = 0.0;
  summary.cpu_s = summary.cpu_real_time_factor = 0.0;
  return SummaryJson(summary);
}

// All that a run leaves behind but what a clock wrote.
std::string Evidence(const std::filesystem::path& run_dir, const RunOutcome& outcome) {
  std::string text = WithoutWallClock(run_dir / "trajectory.csv") +
                     WithoutWallClock(run_dir / "mpc.csv") + TextOf(run_dir / "states.bin") +
                     TextOf(run_dir / "footsteps.csv") + TextOf(run_dir / "scenario.yaml") +
                     SummaryText(run_dir);
  for (const auto& [name, value] : outcome.metrics) {
    char bits[sizeof(double)] = {};
    if (const double* number = std::get_if<double>(&value)) {
      std::memcpy(bits, number, sizeof bits);
    } else {
      bits[0] = std::get<bool>(value) ? 1 : 0;
    }
    text += name + std::string(bits, sizeof bits);
  }
  return text;
}

// An episode with its recorder and folder.
class Run {
 public:
  explicit Run(const Scenario& scenario, const ControllerFactory& make_controller = MakeController)
      : episode_(StartEpisode(scenario, make_controller)),
        recorder_(std::make_unique<Recorder>(scenario, *episode_.world, folder_.path(),
                                             std::vector<std::string>{})) {}

  std::unique_ptr<Run> Forked() const { return std::unique_ptr<Run>(new Run(*this)); }

  void GoOnTo(Tick until) { RunEpisode(&episode_, {.recorder = recorder_.get()}, until); }
  void GoOn() { GoOnTo(episode_.tick + kSlice); }
  bool is_over() const { return episode_.is_over; }
  Tick tick() const { return episode_.tick; }

  std::string Finish() {
    const RunOutcome outcome = episode_.judge.Conclude();
    recorder_->Finish(outcome, episode_.time_s(), {1.0, 1.0});
    return Evidence(folder_.path(), outcome);
  }

 private:
  Run(const Run& other)
      : episode_(Fork(other.episode_)), recorder_(other.recorder_->ForkTo(folder_.path())) {}

  TempFolder folder_;
  Episode episode_;
  std::unique_ptr<Recorder> recorder_;
};

// The run's last tick and evidence without a fork.
std::pair<Tick, std::string> Straight(const Scenario& scenario, const ControllerFactory& make) {
  Run run(scenario, make);
  while (!run.is_over()) run.GoOn();
  const Tick last = run.tick();
  return {last, run.Finish()};
}

// Evidence of the original and of the fork that is taken at the beginning of tick `at`; the two go
// on by turns, so that what they shared would show.
std::pair<std::string, std::string> Forked(const Scenario& scenario, Tick at,
                                           const ControllerFactory& make) {
  Run original(scenario, make);
  original.GoOnTo(at);
  const std::unique_ptr<Run> fork = original.Forked();
  while (!original.is_over() || !fork->is_over()) {
    original.GoOn();
    fork->GoOn();
  }
  return {original.Finish(), fork->Finish()};
}

class ForkTest : public testing::TestWithParam<std::string> {};

TEST_P(ForkTest, AForkedRunIsTheStraightRunBitForBit) {
  const Scenario scenario = Shipped(GetParam());
  const auto [last, straight] = Straight(scenario, MakeController);
  std::mt19937_64 random(scenario.duration_s * 1000.0 + 7.0);
  const Tick at = std::uniform_int_distribution<Tick>(last / 10, 9 * last / 10)(random);
  const auto [original, fork] = Forked(scenario, at, MakeController);
  EXPECT_GT(straight.size(), 100000U);
  EXPECT_TRUE(original == straight) << "the original was disturbed by the fork at tick " << at;
  EXPECT_TRUE(fork == straight) << "the fork at tick " << at << " went its own way";
}

INSTANTIATE_TEST_SUITE_P(Shipped, ForkTest, testing::ValuesIn(ShippedNames()),
                         [](const auto& param) { return param.param; });

// No shipped scenario has the baselines in the MPC's place.
class BaselineForkTest : public testing::TestWithParam<std::string> {};

TEST_P(BaselineForkTest, AForkWithAFootInTheAirIsTheStraightRunBitForBit) {
  const std::string stepping = "control.stepping=" + GetParam();
  for (const Scenario& scenario :
       {Shipped("icub_torque_push", {stepping, "duration_s=7"}),
        Shipped("two_legs", {stepping, "gait={type: walk, step_width_m: 0.2}", "duration_s=4"})}) {
    const std::string straight = Straight(scenario, MakeController).second;
    const Tick at = TickAt(scenario.pushes[0].start_s + 0.123, scenario.world.step_s);
    const auto [original, fork] = Forked(scenario, at, MakeController);
    EXPECT_GT(straight.size(), 100000U);
    EXPECT_TRUE(original == straight) << "the original was disturbed by the fork";
    EXPECT_TRUE(fork == straight) << "the fork went its own way";
  }
}

INSTANTIATE_TEST_SUITE_P(All, BaselineForkTest, testing::Values("dcm_qp", "capture_point"),
                         [](const auto& param) { return param.param; });

// All metrics of a run and its verdict, bit for bit.
std::string Bits(const RunOutcome& outcome) {
  std::string text(EnumName(outcome.verdict.verdict_class));
  for (const Reason& reason : outcome.verdict.reasons) text += reason.kind + reason.text;
  for (const auto& [name, value] : outcome.metrics) {
    char bits[sizeof(double)] = {};
    if (const double* number = std::get_if<double>(&value)) {
      std::memcpy(bits, number, sizeof bits);
    } else {
      bits[0] = std::get<bool>(value) ? 1 : 0;
    }
    text += name + std::string(bits, sizeof bits);
  }
  for (const PushRecord& push : outcome.pushes) {
    text += std::to_string(push.figures.steps_taken) + " " +
            std::to_string(push.impulse_W_Ns.norm()) + " ";
  }
  return text;
}

RunOutcome OutcomeOf(Episode episode) {
  RunEpisode(&episode, {});
  return episode.judge.Conclude();
}

class OtherPushesTest : public testing::TestWithParam<std::string> {};

TEST_P(OtherPushesTest, AForkUnderOtherPushesIsTheirStraightRunBitForBit) {
  Scenario scenario = Shipped(GetParam());
  scenario.pushes.resize(1);
  scenario.duration_s = std::min(scenario.duration_s, scenario.pushes[0].start_s + 4.0);
  Scenario other = scenario;
  other.pushes[0].force_N =
      0.4 * Eigen::Vector3d(-scenario.pushes[0].force_N.y(), scenario.pushes[0].force_N.x(), 0.0);
  other.pushes[0].start_s += 0.05;

  Episode before = StartEpisode(scenario);
  RunEpisode(&before, {}, TickAt(scenario.pushes[0].start_s, scenario.world.step_s) - 1);
  const std::string straight = Bits(OutcomeOf(StartEpisode(other)));
  EXPECT_TRUE(Bits(OutcomeOf(ForkWithPushes(before, other.pushes))) == straight);
  EXPECT_TRUE(Bits(OutcomeOf(std::move(before))) == Bits(OutcomeOf(StartEpisode(scenario))));
  EXPECT_FALSE(Bits(OutcomeOf(StartEpisode(scenario))) == straight) << "the pushes do nothing";
}

INSTANTIATE_TEST_SUITE_P(Pushed, OtherPushesTest,
                         testing::Values("hopper_push", "one_leg", "two_legs", "icub_torque_push"),
                         [](const auto& param) { return param.param; });

TEST(OtherPushesControlTest, AnEpisodeWithinAPushTakesNoOthers) {
  const Scenario scenario = Shipped("one_leg");
  Episode within = StartEpisode(scenario);
  RunEpisode(&within, {}, TickAt(scenario.pushes[0].start_s, scenario.world.step_s));
  EXPECT_THROW(ForkWithPushes(within, scenario.pushes), ContractViolation);
}

// Commands a little more torque at every call; how many there were, all its copies count together.
class SecretCounter final : public Controller {
 public:
  explicit SecretCounter(std::unique_ptr<Controller> inner) : inner_(std::move(inner)) {}

  const ControlTick& Update(const SensorFrame& frame) override {
    tick_ = inner_->Update(frame);
    tick_.command.torque_Nm.array() += 1e-6 * static_cast<double>(++*count_);
    return tick_;
  }

  std::unique_ptr<Controller> Clone(StageTimer* timer) const override {
    auto copy = std::make_unique<SecretCounter>(inner_->Clone(timer));
    copy->count_ = count_;
    return copy;
  }

 private:
  std::unique_ptr<Controller> inner_;
  std::shared_ptr<int> count_{std::make_shared<int>(0)};
  ControlTick tick_;
};

TEST(ForkControlTest, AControllerThatHidesStateFromItsCopiesIsFoundOut) {
  Scenario scenario = Shipped("hopper_push");
  scenario.duration_s = 3.0;
  scenario.pushes.resize(1);
  const ControllerFactory make = [](const ControllerSetup& setup, StageTimer* timer) {
    return std::make_unique<SecretCounter>(MakeController(setup, timer));
  };
  const std::string straight = Straight(scenario, make).second;
  const auto [original, fork] = Forked(scenario, 1234, make);
  EXPECT_FALSE(original == straight);
  EXPECT_FALSE(fork == straight);
}

}  // namespace
}  // namespace sidestep
