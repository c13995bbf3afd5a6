// SPDX-License-Identifier: BSD-3-Clause
// The iCub's shipped scenarios and their controls: what must pass passes, and what must fall falls.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

const std::string kPush = "icub_walk_right_arm_push";

void ExpectPass(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const ClosedLoopRun run(name, overrides);
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

TEST(IcubTest, Stands) { ExpectPass("icub_stand"); }

TEST(IcubTest, BearsAShoveAtTheChestStanding) { ExpectPass("icub_stand_push"); }

TEST(IcubTest, FallsUnderTwiceTheShoveAtTheChest) {
  const ClosedLoopRun run(
      "icub_stand_push",
      {"pushes=[{body: chest, force_N: [160, 0, 0], start_s: 2.0, duration_s: 0.5}]"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(IcubTest, FallsUnderTheShoveAtTheChestIfItDoesNotFeelIt) {
  const ClosedLoopRun run("icub_stand_push", {"control.estimation.push_cutoff_hz=0"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(IcubTest, WalksSixteenSteps) { ExpectPass("icub_walk"); }

TEST(IcubTest, WalksFast) { ExpectPass("icub_walk_fast"); }

TEST(IcubTest, WalksSidewaysAndInPlace) { ExpectPass("icub_walk_sideways"); }

TEST(IcubTest, SurvivesThePapersPushesThatItFeelsByItsArm) { ExpectPass(kPush); }

TEST(IcubTest, SurvivesThePapersPushesUntold) { ExpectPass(kPush + "_unknown"); }

TEST(IcubTest, SurvivesThePapersPushesTold) { ExpectPass(kPush + "_known"); }

TEST(IcubTest, BearsThePapersPushesWithoutStepAdjustment) { ExpectPass(kPush + "_no_adjustment"); }

TEST(IcubTest, SurvivesThePapersPushesThoughFivePercentHeavierThanItBelieves) {
  ExpectPass(kPush, {"world.mass_scale=1.05"});
}

TEST(HumanoidTest, AnotherUrdfWalksWithTheSameController) { ExpectPass("humanoid_walk"); }

TEST(HumanoidTest, XbotLStandsWalksAndIsPushed) {
  for (const char* name :
       {"xbot_l_stand", "xbot_l_walk", "xbot_l_push", "xbot_l_push_no_adjustment"}) {
    ExpectPass(name);
  }
}

TEST(IcubTest, FallsWhenItDoesNothing) {
  const ClosedLoopRun run("icub_walk", {"control.mode=passive"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(IcubTest, FallsUnderFiveTimesThePush) {
  const ClosedLoopRun run(
      kPush, {"pushes=[{body: r_hand, force_N: [0, 200, 0], start_s: 8.0, duration_s: 1.0}]"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

}  // namespace
}  // namespace sidestep
