// SPDX-License-Identifier: BSD-3-Clause
// The hopper's shipped scenarios and their negative controls: what must pass passes, and what must
// fall falls for the right reason.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/closed_loop.h"
#include "tests/support/run_files.h"

namespace sidestep {
namespace {

const std::string kFirstPushOnly =
    "pushes=[{body: trunk, force_N: [5, 0, 0], start_s: 2.0, duration_s: 0.5}]";
const std::string kTenTimesThePush =
    "pushes=[{body: trunk, force_N: [50, 0, 0], start_s: 2.0, duration_s: 0.5}]";
const std::vector<std::string> kNoStepAdjustment{"control.mpc.box_lower_m=[0, 0, 0]",
                                                 "control.mpc.box_upper_m=[0, 0, 0]"};

TEST(HopperTest, HopsInPlaceAndTravels) {
  const ClosedLoopRun run("hopper_hop");
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

TEST(HopperTest, SurvivesEveryShippedPush) {
  const ClosedLoopRun run("hopper_push");
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

TEST(HopperTest, FallsWhenItDoesNothing) {
  const ClosedLoopRun run("hopper_push", {"control.mode=passive"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(HopperTest, FallsUnderTenTimesThePush) {
  const ClosedLoopRun run("hopper_push", {kTenTimesThePush});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(HopperTest, FallsUnderTheShippedPushWhenItMayNotMoveItsSteps) {
  std::vector<std::string> overrides = kNoStepAdjustment;
  overrides.push_back(kFirstPushOnly);
  const ClosedLoopRun run("hopper_push", overrides);
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

// A point foot needs some step to balance at all: two centimetres do, but not for a push.
TEST(HopperTest, TwoCentimetresOfStepAdjustmentHopButDoNotSave) {
  std::vector<std::string> overrides{"control.mpc.box_lower_m=[-0.02, -0.02, 0]",
                                     "control.mpc.box_upper_m=[0.02, 0.02, 0]", "duration_s=6.0",
                                     "expect={fall: false}", "pushes=[]"};
  const ClosedLoopRun unpushed("hopper_push", overrides);
  EXPECT_EQ(unpushed.verdict.verdict_class, VerdictClass::kPass) << unpushed.Describe();
  overrides.back() = kFirstPushOnly;
  const ClosedLoopRun pushed("hopper_push", overrides);
  EXPECT_TRUE(pushed.FailedBy(reason::kFall)) << pushed.Describe();
}

TEST(HopperTest, RunsAlikeTwice) {
  const std::vector<std::string> overrides{"duration_s=3.5", kFirstPushOnly,
                                           "expect={fall: false}"};
  const ClosedLoopRun first("hopper_push", overrides);
  const ClosedLoopRun second("hopper_push", overrides);
  const std::string once = WithoutWallClock(first.folder.path() / "trajectory.csv");
  EXPECT_GT(once.size(), 100000U);
  EXPECT_EQ(once, WithoutWallClock(second.folder.path() / "trajectory.csv"));
}

TEST(HopperTest, AnotherSeedIsAnotherRun) {
  const std::vector<std::string> overrides{"duration_s=1.0", "pushes=[]", "expect={fall: false}"};
  std::vector<std::string> reseeded = overrides;
  reseeded.emplace_back("seed=2");
  const ClosedLoopRun first("hopper_push", overrides);
  const ClosedLoopRun second("hopper_push", reseeded);
  EXPECT_NE(WithoutWallClock(first.folder.path() / "trajectory.csv"),
            WithoutWallClock(second.folder.path() / "trajectory.csv"));
}

}  // namespace
}  // namespace sidestep
