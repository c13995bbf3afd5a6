// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/map_physics.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "sim/map/map_commands.h"
#include "sim/scenario/read_scenario.h"
#include "sim/sweep/read_sweep.h"

namespace sidestep::map {
namespace {

const std::filesystem::path kScenarios = std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios";

// A walk's push at a phase of a foot's stride: that foot swings.
TEST(MapPhysicsTest, TheStepIsThatOfTheFootInTheAir) {
  for (const bool is_right : {false, true}) {
    const Scenario scenario =
        ReadScenario(kScenarios / "icub_torque_push.yaml",
                     {"pushes.0.at_phase=mid_swing", "pushes.0.after_s=4",
                      std::string("pushes.0.foot=") + (is_right ? "right" : "left")});
    const StepMoment moment = MomentOf(scenario, scenario.pushes.at(0).start_s);
    EXPECT_NEAR(moment.time_s, 0.2, 1e-9) << "half of the 0.4 s in the air";
    EXPECT_EQ(moment.is_mirrored, is_right);
  }
}

TEST(MapPhysicsTest, OnBothFeetItIsThatOfTheFootThatLandedLast) {
  const Scenario scenario =
      ReadScenario(kScenarios / "icub_torque_push.yaml",
                   {"pushes.0.at_phase=swing_to_stance", "pushes.0.after_s=4"});
  const StepMoment moment = MomentOf(scenario, scenario.pushes.at(0).start_s + 0.05);
  EXPECT_NEAR(moment.time_s, 0.45, 1e-9);
  EXPECT_FALSE(moment.is_mirrored);
}

TEST(MapPhysicsTest, OfAHopTimeIsSinceTouchDown) {
  const Scenario scenario = ReadScenario(kScenarios / "hopper_push.yaml",
                                         {"pushes.0.at_phase=mid_stance", "pushes.0.after_s=2"});
  const StepMoment moment = MomentOf(scenario, scenario.pushes.at(0).start_s);
  EXPECT_NEAR(moment.time_s, 0.075, 1e-9) << "half of the 0.15 s on the ground";
}

TEST(MapCommandsTest, WordsAreQuotedForAShell) {
  EXPECT_EQ(ShellWord("a.b=1"), "a.b=1");
  EXPECT_EQ(ShellWord("a=[0, 1]"), "'a=[0, 1]'");
  EXPECT_EQ(ShellWord("it's; rm"), "'it'\\''s; rm'");
  EXPECT_EQ(ShellWord(""), "''");
}

TEST(MapCommandsTest, ACommandHasTheSweepsKeysInTheirOrder) {
  SweepOptions options;
  options.set = {"duration_s=5"};
  options.vary = {"pushes.0.direction_rad=[0, 1.5]"};
  options.limit = "pushes.0.magnitude_N=[10, 20]";
  options.controllers = {"{a: {}, b: {control.mpc.box_upper_m: [0, 0, 0]}}"};
  const SweepSpec spec = ReadSweep(kScenarios / "hopper_push.yaml", options);
  const Ray ray = RaysOf(spec).at(3);
  EXPECT_EQ(RunCommand(spec, ray, {3, "20", "7", SearchStage::kLadder}),
            "sidestep run hopper_push --set duration_s=5 --set "
            "'control.mpc.box_upper_m=[0, 0, 0]' --set pushes.0.direction_rad=1.5 --set "
            "pushes.0.magnitude_N=20 --set seed=7");
}

}  // namespace
}  // namespace sidestep::map
