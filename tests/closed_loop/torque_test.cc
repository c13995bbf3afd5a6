// SPDX-License-Identifier: BSD-3-Clause
// Humanoids on soles, moved by their joints' torques: the position-controlled walks in that mode, a
// quick gait, and shoves that only steps save them from.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

std::vector<std::string> OnTorques(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), {"control.mode=torque", "control.rate_hz=500"});
  return overrides;
}

void ExpectPass(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const ClosedLoopRun run(name, OnTorques(overrides));
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

/// 157 N for 0.1 s are 0.3 N s/kg; to the left, over the foot that stands while the right one
/// swings.
std::vector<std::string> ShovedInPlace(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{
      "duration_s=8",
      "expect={fall: false}",
      "control.external_wrench=unknown",
      "control.mpc.friction=0.5",
      "gait={type: walk, step_length_m: 0, step_width_m: 0.16, swing_s: 0.4, double_support_s: "
      "0.1, "
      "swing_height_m: 0.03, landing_speed_mps: 0.02}",
      "pushes=[{body: chest, force_N: [0, 157, 0], start_s: 4.1, duration_s: 0.1}]"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return OnTorques(overrides);
}

TEST(TorqueTest, IcubStands) { ExpectPass("icub_stand"); }

TEST(TorqueTest, IcubWalksAsThePapers) { ExpectPass("icub_walk"); }

TEST(TorqueTest, IcubWalksWithFourTenthsInTheAirAndOneOnBothFeet) {
  ExpectPass("icub_walk_fast", {"gait.0.swing_s=0.4", "gait.0.double_support_s=0.1",
                                "gait.1.landing_speed_mps=0.02"});
}

TEST(TorqueTest, AnotherHumanoidWalksWithTheSameGains) { ExpectPass("humanoid_walk"); }

TEST(TorqueTest, IcubFallsWhenItDoesNothing) {
  const ClosedLoopRun run("icub_stand", {"control.mode=passive"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(TorqueTest, IcubCatchesItselfByAStep) {
  const ClosedLoopRun run("icub_walk_fast", ShovedInPlace());
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

// Every metric that the two walks share, to the last bit: timing is silent until somebody pushes.
TEST(TorqueTest, IcubThatNothingPushesStepsByTheClockToTheLastBit) {
  const auto measured = [](const std::string& error_m) {
    const ClosedLoopRun run("icub_torque_walk", {"control.planner.timing.error_m=" + error_m});
    return run.verdict.expectations;
  };
  const auto in_time = measured("0.04"), by_the_clock = measured("0");
  ASSERT_EQ(in_time.size(), by_the_clock.size());
  ASSERT_GT(in_time.size(), 5U);
  for (std::size_t i = 0; i < in_time.size(); ++i) {
    EXPECT_EQ(in_time[i].measured, by_the_clock[i].measured) << i;
  }
}

TEST(TorqueTest, IcubFallsUnderTheSameShoveWhenItMayNotMoveItsSteps) {
  const ClosedLoopRun run("icub_walk_fast", ShovedInPlace({"control.planner.timing.error_m=0",
                                                           "control.mpc.box_lower_m=[0, 0, 0]",
                                                           "control.mpc.box_upper_m=[0, 0, 0]"}));
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

class TorqueScenarioTest : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Shipped, TorqueScenarioTest,
                         testing::Values("icub_torque_stand", "icub_torque_walk",
                                         "icub_torque_push", "icub_torque_push_no_adjustment",
                                         "icub_torque_push_no_timing", "icub_torque_push_long",
                                         "icub_torque_stand_push", "humanoid_torque_walk",
                                         "humanoid_torque_push", "g1_stand", "g1_walk", "g1_push",
                                         "g1_push_no_adjustment"));

TEST_P(TorqueScenarioTest, EndsAsExpected) {
  const ClosedLoopRun run(GetParam());
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

// Standing it catches itself by steps alone.
TEST(TorqueTest, IcubThatMayNotStepFallsWhereItStood) {
  const ClosedLoopRun run("icub_torque_stand_push", {"control.planner.timing.error_m=0"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

}  // namespace
}  // namespace sidestep
