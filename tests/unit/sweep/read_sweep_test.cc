// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/read_sweep.h"

#include <gtest/gtest.h>

#include <ctime>
#include <limits>

#include "tests/support/temp_folder.h"

namespace sidestep::read_sweep_test {
namespace {

constexpr const char* kSweep = R"(sidestep_sweep: 1
name: map
scenario: hopper_push
set: {pushes.0.duration_s: 0.1, pushes.0.force_N: [0, 1, 0]}
vary:
  pushes.0.direction_rad: 0:2pi:4
  world.friction: 0.4:1:latin=3
limit: {key: pushes.0.magnitude_N, ladder: 5:20:4, resolution: 0.5}
controllers:
  ours: {}
  fixed: {control.mpc.box_lower_m: [0, 0, 0]}
seeds: [3, 5]
)";

class ReadSweepTest : public testing::Test {
 protected:
  SweepSpec Read(const std::string& text, const SweepOptions& options = {}) const {
    return ReadSweep(folder_.Write("map.yaml", text), options);
  }
  std::string ErrorOfEdit(const std::string& from, const std::string& to) const {
    return folder_.ErrorOf([&] { Read(Edit(kSweep, from, to)); });
  }
  std::string ErrorOfOptions(const SweepOptions& options) const {
    return folder_.ErrorOf([&] { ReadSweep("hopper_push", options); });
  }

  const TempFolder folder_;
};

TEST_F(ReadSweepTest, ReadsAllOfAFile) {
  const SweepSpec spec = Read(kSweep);
  EXPECT_EQ(spec.name, "map");
  EXPECT_TRUE(spec.scenario.is_absolute());
  EXPECT_EQ(spec.scenario.filename(), "hopper_push.yaml");
  EXPECT_EQ(spec.set,
            (std::vector<std::string>{"pushes.0.duration_s=0.1", "pushes.0.force_N=[0, 1, 0]"}));
  ASSERT_EQ(spec.axes.size(), 2U);
  EXPECT_EQ(spec.axes[0].values.size(), 4U);
  EXPECT_EQ(spec.axes[1].kind, AxisKind::kLatin);
  ASSERT_TRUE(spec.limit);
  EXPECT_EQ(spec.limit->ladder, (std::vector<double>{5, 10, 15, 20}));
  EXPECT_EQ(spec.limit->resolution, 0.5);
  ASSERT_EQ(spec.controllers.size(), 2U);
  EXPECT_EQ(spec.controllers[1].set, std::vector<std::string>{"control.mpc.box_lower_m=[0, 0, 0]"});
  EXPECT_EQ(spec.seeds, (std::vector<std::uint64_t>{3, 5}));
}

TEST_F(ReadSweepTest, WhatIsWrittenReadsBackTheSame) {
  const std::string text = SweepYaml(Read(kSweep));
  EXPECT_EQ(SweepYaml(Read(text)), text);
}

TEST_F(ReadSweepTest, TheCommandLineSaysTheSame) {
  SweepOptions options;
  options.set = {"pushes.0.duration_s=0.1", "pushes.0.force_N=[0, 1, 0]"};
  options.vary = {"pushes.0.direction_rad=0:2pi:4", "world.friction=0.4:1:latin=3",
                  "pushes.0.magnitude_N=5:20:4"};
  options.limit = "pushes.0.magnitude_N";
  options.resolution = 0.5;
  options.controllers = {"ours: {}", "fixed: {control.mpc.box_lower_m: [0, 0, 0]}"};
  options.seeds = "[3, 5]";
  SweepSpec spec = ReadSweep("hopper_push", options);
  EXPECT_EQ(spec.name, "hopper_push");
  spec.name = "map";
  EXPECT_EQ(SweepYaml(spec), SweepYaml(Read(kSweep)));
}

TEST_F(ReadSweepTest, TheResolutionIsAnEighthOfTheSmallestGapUnlessTold) {
  EXPECT_EQ(Read(Edit(kSweep, ", resolution: 0.5", "")).limit->resolution, 5.0 / 8.0);
}

TEST_F(ReadSweepTest, FileErrors) {
  EXPECT_EQ(ErrorOfEdit("pushes.0.direction_rad:", "pushes.0.direction_deg:"),
            "map.yaml:6:3: error: pushes.direction_deg is not a known key; did you mean "
            "'direction_rad'?");
  EXPECT_EQ(ErrorOfEdit("0:2pi:4", "3:1:4"),
            "map.yaml:6:27: error: pushes.0.direction_rad = 3:1:4 is an empty range: it must go "
            "upwards");
  EXPECT_EQ(ErrorOfEdit("scenario: hopper_push", "scenario: hoper"),
            "map.yaml:3:11: error: scenario = 'hoper' is no scenario, neither beside this file nor "
            "one that ships");
  EXPECT_EQ(ErrorOfEdit("vary:", "varyy:"),
            "map.yaml:5:1: error: varyy is not a known key; did you mean 'vary'?");
  EXPECT_EQ(ErrorOfEdit("5:20:4", "[5, 5]"),
            "map.yaml:8:44: error: pushes.0.magnitude_N: a ladder is of rising numbers above 0");
  EXPECT_EQ(ErrorOfEdit("control.mpc.box_lower_m", "control.mpc.box_lowr_m"),
            "map.yaml:11:11: error: control.mpc.box_lowr_m is not a known key; did you mean "
            "'box_lower_m'?");
  EXPECT_EQ(ErrorOfEdit("[3, 5]", "[3, 3]"), "map.yaml:12:12: error: seeds.1 = 3 is there twice");
  EXPECT_EQ(ErrorOfEdit("sidestep_sweep: 1", "sidestep_sweep: 2"),
            "map.yaml:1:17: error: sidestep_sweep = 2 is a format that this program can't read; it "
            "reads 1");
}

// An axis wins over what a controller sets, and seeds over an axis: that must not pass in silence.
TEST_F(ReadSweepTest, NothingIsToldTwice) {
  SweepOptions options;
  options.vary = {"world.friction=[0.5, 0.8]"};
  options.controllers = {"slippery: {world.friction: 0.2}"};
  EXPECT_EQ(ErrorOfOptions(options),
            "controllers: error: 'slippery' sets world.friction, which is varied");
  SweepOptions seeds;
  seeds.vary = {"seed=[1, 2]"};
  seeds.seeds = "3";
  EXPECT_EQ(ErrorOfOptions(seeds), "seeds: error: seed is varied too");
}

TEST_F(ReadSweepTest, ManySeedsAreReadBackInTheTimeOfAFew) {
  SweepOptions options;
  options.seeds = "100000";
  const std::clock_t start = std::clock();
  EXPECT_EQ(Read(SweepYaml(ReadSweep("hopper_push", options))).seeds.size(), 100'000U);
  const double cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(cpu_s, 6.0);  // 1.4 s with sanitizers; every pair compared, it was 54 s
}

TEST_F(ReadSweepTest, CombinationsAreNotWithoutNumber) {
  SweepOptions options;
  options.vary = {"pushes.0.direction_rad=0:1:1000", "pushes.0.start_s=2:3:1000"};
  EXPECT_EQ(ErrorOfOptions(options), "no error");
  options.vary.push_back("world.friction=0.5:1:1000");
  EXPECT_EQ(ErrorOfOptions(options),
            "vary: error: makes 1e+09 combinations with the controllers, more than 1e+06");
}

TEST_F(ReadSweepTest, AResolutionIsANumber) {
  SweepOptions options;
  options.limit = "pushes.0.magnitude_N=[1, 2]";
  options.resolution = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ErrorOfOptions(options), "--resolution: error: must be a number above 0");
}

TEST_F(ReadSweepTest, OptionErrors) {
  SweepOptions no_ladder;
  no_ladder.limit = "pushes.0.magnitude_N";
  EXPECT_EQ(ErrorOfOptions(no_ladder),
            "--limit pushes.0.magnitude_N: error: the limit pushes.0.magnitude_N has no ladder: "
            "vary it too, or write it after the key");
  SweepOptions twice;
  twice.vary = {"world.friction=[1]", "world.friction=[2]"};
  EXPECT_EQ(ErrorOfOptions(twice),
            "--vary world.friction=[2]: error: world.friction is varied twice");
  SweepOptions uneven;
  uneven.vary = {"world.friction=0.1:1:random=3", "world.mass_scale=0.9:1.1:random=4"};
  EXPECT_EQ(ErrorOfOptions(uneven),
            "--vary world.mass_scale=0.9:1.1:random=4: error: world.mass_scale = "
            "0.9:1.1:random=4 must have as many values as world.friction, 3: they are drawn "
            "together");
}

}  // namespace
}  // namespace sidestep::read_sweep_test
