// SPDX-License-Identifier: BSD-3-Clause
// Those who look on see the whole run, may be absent, and never disturb it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "sim/episode/run_episode.h"
#include "tests/support/run_files.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/episode/episode_test_support.h"

namespace sidestep::onlookers_test {
namespace {

namespace fs = std::filesystem;

constexpr double kDuration_s = 0.25;

std::size_t NumLines(const fs::path& file) {
  const std::string text = TextOf(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::string BitsUnder(const Onlookers& onlookers, Episode episode) {
  RunEpisode(&episode, onlookers);
  return BitsOf(episode.world->truth());
}

TEST(OnlookersTest, EachMayBeAbsentAndNoneDisturbsTheRun) {
  const Scenario scenario = ShortHop(kDuration_s);
  const auto start = [&] { return StartEpisode(scenario, TorqueBy(NoisyTorque)); };
  const std::string alone = BitsUnder({}, start());
  const TempFolder folder;
  Episode recorded = start();
  Recorder recorder(scenario, *recorded.world, folder.path() / "run", {});
  EXPECT_EQ(BitsUnder({&recorder, nullptr, {}}, std::move(recorded)), alone);
  recorder.Finish({}, kDuration_s, {});
  EXPECT_EQ(NumLines(folder.path() / "run/trajectory.csv"), 1u + 126u) << "0, 2 ... 250 ms";
  ProblemDump dump(folder.path() / "dump", true);
  EXPECT_EQ(BitsUnder({nullptr, &dump, {}}, start()), alone);
  int num_calls = 0;
  EXPECT_EQ(BitsUnder({.progress = [&](double, double) { ++num_calls; }}, start()), alone);
  EXPECT_EQ(num_calls, 3);
}

TEST(OnlookersTest, ProgressIsToldEveryTenthOfASimulatedSecondFromTheStartOn) {
  Episode episode = StartEpisode(ShortHop(kDuration_s), TorqueBy(NoTorque));
  std::vector<double> times_s;
  const EpisodeProgress progress = [&](double time_s, double duration_s) {
    times_s.push_back(time_s);
    EXPECT_EQ(duration_s, kDuration_s);
  };
  RunEpisode(&episode, {.progress = progress}, 150);
  EXPECT_EQ(times_s, (std::vector<double>{0.0, 0.1}));
  RunEpisode(&episode, {.progress = progress});
  EXPECT_EQ(times_s, (std::vector<double>{0.0, 0.1, 0.2})) << "it goes on and tells nothing twice";
}

// Says at every tenth tick (20 ms) that it solved a problem, at 60 and 160 ms that it failed, and
// counts who wants to read one.
class SolvingController final : public Controller {
 public:
  explicit SolvingController(int* num_texts) : num_texts_(num_texts) {}

  const ControlTick& Update(const SensorFrame& frame) override {
    tick_.tick = frame.tick;
    tick_.command.torque_Nm.setZero(frame.joint_position.size());
    tick_.mpc.ran = frame.tick % 20 == 0;
    tick_.mpc.fell_back = tick_.mpc.ran && frame.tick % 100 == 60;
    return tick_;
  }
  std::unique_ptr<Controller> Clone(StageTimer* /*timer*/) const override {
    return std::make_unique<SolvingController>(*this);
  }
  std::string LastProblemJson(const std::string& name) const override {
    ++*num_texts_;
    return name + " of tick " + std::to_string(tick_.tick);
  }

 private:
  int* num_texts_;
  ControlTick tick_;
};

class DumpTest : public ::testing::Test {
 protected:
  // Runs with a dump that keeps every problem, or failed ones alone.
  void RunWith(bool every) {
    Episode episode =
        StartEpisode(ShortHop(kDuration_s), [this](const ControllerSetup&, StageTimer*) {
          return std::make_unique<SolvingController>(&num_texts_);
        });
    ProblemDump dump(folder_.path(), every);
    RunEpisode(&episode, {nullptr, &dump, {}});
  }

  std::size_t NumFiles() const {
    const fs::directory_iterator files(folder_.path() / "problems");
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

  TempFolder folder_;
  int num_texts_{0};
};

TEST_F(DumpTest, AProblemThatFailedIsKeptUnderTheTimeOfItsTick) {
  RunWith(false);
  EXPECT_EQ(NumFiles(), 2u);
  EXPECT_EQ(TextOf(folder_.path() / "problems/mpc_0000060.json"), "mpc_0000060 of tick 60");
  EXPECT_EQ(TextOf(folder_.path() / "problems/mpc_0000160.json"), "mpc_0000160 of tick 160");
  EXPECT_EQ(num_texts_, 2) << "nobody asks for the text of a problem that gets no file";
}

TEST_F(DumpTest, EveryProblemIsKeptOnRequestAndTicksWithoutASolveHaveNone) {
  RunWith(true);
  EXPECT_EQ(NumFiles(), 13u) << "0, 20 ... 240 ms";
  EXPECT_EQ(num_texts_, 13);
}

}  // namespace
}  // namespace sidestep::onlookers_test
