// SPDX-License-Identifier: BSD-3-Clause
// Recovery of robots that are late: by what they are at, not by the clock.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/verdict/moving_com.h"

namespace sidestep::late_robot_test {
namespace {

TEST(LateRobotTest, IsNotChargedForItsPhaseOnItsPath) {
  // Stops for 0.5 s, then walks the same path half a second late; or 3 s late, two cycles.
  const Scenario scenario = PushedWalkScenario();
  for (const double delay_s : {0.5, 3.0}) {
    const RunOutcome outcome = RunOf(scenario, 10.0, NominalLate(scenario, [=](double time_s) {
                                       return std::clamp(time_s - 4.0, 0.0, delay_s);
                                     }));
    EXPECT_TRUE(FlagOf(outcome, "recovered")) << delay_s;
    EXPECT_LT(NumberOf(outcome, "max_path_error_m"), 1e-4) << delay_s;
    EXPECT_LT(NumberOf(outcome, "drift_m"), 1e-4) << delay_s;
  }
}

TEST(LateRobotTest, MayStillWalkWhenTheClockHasItStand) {
  // 1.5 s late from the start on; the gait stands from 4.8 s on, before a second after the push is
  // over, and the run ends before the robot does.
  Scenario scenario = PushedWalkScenario();
  scenario.gait.resize(2);
  scenario.gait[1].type = GaitType::kStand;
  scenario.gait[1].start_s = 4.0;
  const RunOutcome outcome =
      RunOf(scenario, 6.0, NominalLate(scenario, [](double) { return 1.5; }));
  EXPECT_TRUE(FlagOf(outcome, "recovered"));
  EXPECT_GT(NumberOf(outcome, "final_speed_error_mps"), 0.3) << "by the clock it should stand";
}

TEST(LateRobotTest, WalksOnBeyondTheEndOfItsPathAndNeverRecovers) {
  Scenario scenario = PushedWalkScenario();
  scenario.gait.resize(2);
  scenario.gait[1].type = GaitType::kStand;
  scenario.gait[1].start_s = 4.0;
  const RunOutcome outcome =
      RunOf(scenario, 9.0, [](double time_s) { return Eigen::Vector3d(0.5 * time_s, 0.0, 0.5); });
  EXPECT_FALSE(FlagOf(outcome, "recovered"));
}

}  // namespace
}  // namespace sidestep::late_robot_test
