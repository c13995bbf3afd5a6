// SPDX-License-Identifier: BSD-3-Clause
// Recovery, by its one definition, through the judge: closed-form motions and their negatives.
#include "sim/verdict/push_meter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "tests/unit/verdict/moving_com.h"

namespace sidestep::push_meter_test {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Stands; one push from 1.0 s to 1.5 s.
Scenario StandScenario() {
  Scenario scenario = OneFootScenario();
  PushAt(scenario, 1.0, 0.5);
  return scenario;
}

TEST(PushMeterTest, RobotThatComesBackRecoversWhenItIsBack) {
  // Away by 0.2 m from 1.2 s to 2.0 s. A stand's cycle is 1 s. By hand: the mean offset is 0.16 m
  // at 2.0 s and below 0.05 m from 2.75 s on; the mean speed is 0.2 m/s while the second before
  // began away from where it ended, until 3.0 s. So it recovers 1.5 s after the push's end.
  const RunOutcome outcome = RunOf(StandScenario(), 6.0, [](double time_s) {
    return Eigen::Vector3d(0.0, time_s > 1.2 && time_s <= 2.0 ? 0.2 : 0.0, 0.5);
  });
  EXPECT_NEAR(NumberOf(outcome, "recovery_time_s"), 1.5, 0.003);
}

TEST(PushMeterTest, RobotThatWasNotMovedRecoversAtOnce) {
  const RunOutcome outcome =
      RunOf(StandScenario(), 3.0, [](double) { return Eigen::Vector3d(0.0, 0.01, 0.5); });
  EXPECT_TRUE(FlagOf(outcome, "recovered"));
  EXPECT_EQ(NumberOf(outcome, "recovery_time_s"), 0.0);
}

TEST(PushMeterTest, RecoveryMustLastForASecondBeforeTheRunEnds) {
  const ComOf still = [](double) { return Eigen::Vector3d(0.0, 0.0, 0.5); };
  EXPECT_TRUE(FlagOf(RunOf(StandScenario(), 2.5, still), "recovered"));
  const RunOutcome short_run = RunOf(StandScenario(), 2.49, still);
  EXPECT_FALSE(FlagOf(short_run, "recovered"));
  EXPECT_EQ(NumberOf(short_run, "recovery_time_s"), kNever);
}

TEST(PushMeterTest, RobotThatWalksOnAsideHasRecoveredAndTheDriftTells) {
  const Scenario scenario = PushedWalkScenario();
  const RunOutcome outcome = RunOf(
      scenario, 10.0, [walk = NominalLate(scenario, [](double) { return 0.0; })](double time_s) {
        const double aside_m = 0.3 * std::clamp((time_s - 4.0) / 0.5, 0.0, 1.0);
        return Eigen::Vector3d(walk(time_s) + Eigen::Vector3d(0.0, aside_m, 0.0));
      });
  EXPECT_TRUE(outcome.pushes.at(0).figures.recovered);
  EXPECT_NEAR(outcome.pushes[0].figures.drift_m, 0.3, 1e-6);
  EXPECT_NEAR(NumberOf(outcome, "drift_m"), 0.3, 1e-6);
  EXPECT_NEAR(NumberOf(outcome, "max_path_error_m"), 0.3, 1e-6);
  // By hand: the mean lags a shift of 0.3 m by a cycle of 1.6 s and is within 0.05 m of it when
  // at most a sixth of it is missing; the speed at the side is then below 0.1 m/s when less than
  // 0.16 m of the shift is within the cycle. The later of both is the former.
  EXPECT_GT(outcome.pushes[0].figures.recovery_time_s, 0.5);
  EXPECT_LT(outcome.pushes[0].figures.recovery_time_s, 1.6);
}

TEST(PushMeterTest, RobotThatStandsStillHasRecovered) {
  const Scenario scenario = PushedWalkScenario();
  const RunOutcome outcome =
      RunOf(scenario, 10.0,
            NominalLate(scenario, [](double time_s) { return std::max(0.0, time_s - 4.2); }));
  EXPECT_TRUE(FlagOf(outcome, "recovered"));
  EXPECT_NEAR(NumberOf(outcome, "final_speed_error_mps"), 0.5, 1e-2) << "but it does not walk on";
}

TEST(PushMeterTest, RobotThatWalksAwayAtAnotherSpeedNeverRecovers) {
  const Scenario scenario = PushedWalkScenario();
  // On the path, but at 0.25 m/s, and at 0.75 m/s.
  for (const double slower : {0.5, -0.5}) {
    const RunOutcome outcome = RunOf(scenario, 10.0, NominalLate(scenario, [=](double time_s) {
                                       return slower * std::max(0.0, time_s - 4.0);
                                     }));
    EXPECT_FALSE(FlagOf(outcome, "recovered")) << slower;
    EXPECT_EQ(NumberOf(outcome, "recovery_time_s"), kNever) << slower;
  }
  // At its speed forwards, but 0.15 m/s to the side.
  const RunOutcome aside = RunOf(
      scenario, 10.0, [walk = NominalLate(scenario, [](double) { return 0.0; })](double time_s) {
        return Eigen::Vector3d(walk(time_s) +
                               Eigen::Vector3d(0.0, 0.15 * std::max(0.0, time_s - 4.0), 0.0));
      });
  EXPECT_FALSE(FlagOf(aside, "recovered"));
}

TEST(PushMeterTest, RobotThatReelsNeverRecovers) {
  const auto reel = [](double amplitude_m) {
    return RunOf(StandScenario(), 6.0, [=](double time_s) {
      return Eigen::Vector3d(0.0, amplitude_m * std::sin(2.0 * std::numbers::pi * time_s), 0.5);
    });
  };
  EXPECT_FALSE(FlagOf(reel(0.06), "recovered")) << "a second's mean of it is zero, and its speed's";
  EXPECT_TRUE(FlagOf(reel(0.04), "recovered"));
}

TEST(PushMeterTest, RobotThatLeansNeverRecovers) {
  const auto lean = [](double angle_rad) {
    return OutcomeOf(StandScenario(), 6000, [=](Tick tick, WorldTruth& truth, ControlTick&) {
      if (tick > 1200) truth.q_WB = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitX());
    });
  };
  EXPECT_FALSE(FlagOf(lean(0.21), "recovered"));
  EXPECT_NEAR(lean(0.21).pushes[0].figures.peak_tilt_rad, 0.21, 1e-12);
  EXPECT_TRUE(FlagOf(lean(0.19), "recovered"));
}

TEST(PushMeterTest, WhatThePlannerFollowsDoesNotMatter) {
  Scenario scenario = PushedWalkScenario();
  const ComOf late =
      NominalLate(scenario, [](double time_s) { return std::clamp(time_s - 4.0, 0.0, 0.5); });
  const double path_s = NumberOf(RunOf(scenario, 10.0, late), "recovery_time_s");
  scenario.control.planner.follow = FollowMode::kCapturePoint;
  EXPECT_EQ(NumberOf(RunOf(scenario, 10.0, late), "recovery_time_s"), path_s);
  EXPECT_TRUE(std::isfinite(path_s));
}

// Three pushes, 4 s apart; it reels by 0.2 m, once a second, for so long after the start of each.
RunOutcome ThreePushes(const std::vector<double>& reels_s) {
  Scenario scenario = OneFootScenario();
  for (const double start_s : {1.0, 5.0, 9.0}) PushAt(scenario, start_s, 0.1);
  return RunOf(scenario, 13.0, [&](double time_s) {
    const double since_s = std::fmod(time_s + 3.0, 4.0);
    const auto at = static_cast<std::size_t>(std::max(0.0, (time_s - 1.0) / 4.0));
    const bool reels = time_s > 1.0 && at < 3 && since_s < reels_s[at];
    return Eigen::Vector3d(0.0, reels ? 0.2 * std::sin(2.0 * std::numbers::pi * since_s) : 0.0,
                           0.5);
  });
}

TEST(PushMeterTest, EveryPushHasItsOwnRecoveryAndTheWorstIsTheRuns) {
  const RunOutcome outcome = ThreePushes({1.0, 0.5, 1.5});
  ASSERT_EQ(outcome.pushes.size(), 3u);
  double worst_s = 0.0;
  for (const PushRecord& push : outcome.pushes) {
    EXPECT_TRUE(push.figures.recovered);
    worst_s = std::max(worst_s, push.figures.recovery_time_s);
  }
  EXPECT_LT(outcome.pushes[1].figures.recovery_time_s, outcome.pushes[2].figures.recovery_time_s);
  EXPECT_EQ(NumberOf(outcome, "recovery_time_s"), worst_s);
  EXPECT_TRUE(FlagOf(outcome, "recovered"));
}

TEST(PushMeterTest, OnePushThatIsNotRecoveredFromBeforeTheNextSpoilsTheRun) {
  const RunOutcome outcome = ThreePushes({1.0, 3.5, 1.0});
  EXPECT_TRUE(outcome.pushes[0].figures.recovered);
  EXPECT_FALSE(outcome.pushes[1].figures.recovered);
  EXPECT_TRUE(outcome.pushes[2].figures.recovered);
  EXPECT_EQ(NumberOf(outcome, "recovery_time_s"), kNever);
  EXPECT_FALSE(FlagOf(outcome, "recovered"));
}

TEST(PushMeterTest, PushesAtMostASecondApartAreOne) {
  Scenario scenario = OneFootScenario();
  PushAt(scenario, 2.0, 0.5);  // the second in time
  PushAt(scenario, 1.0, 0.2);
  PushAt(scenario, 5.0, 0.1);
  const RunOutcome outcome =
      OutcomeOf(scenario, 8000, [](Tick tick, WorldTruth& truth, ControlTick&) {
        const double tilt_rad = tick == 1100 ? 0.3 : tick == 5050 ? 0.1 : 0.0;
        truth.q_WB = Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitX());
      });
  EXPECT_NEAR(outcome.pushes[0].figures.peak_tilt_rad, 0.3, 1e-12) << "they share their window";
  EXPECT_NEAR(outcome.pushes[1].figures.peak_tilt_rad, 0.3, 1e-12);
  EXPECT_NEAR(outcome.pushes[2].figures.peak_tilt_rad, 0.1, 1e-12);
  EXPECT_EQ(outcome.pushes[1].figures.recovery_time_s, 0.0) << "from the last end on";
  scenario.pushes[0].start_s = 2.21;
  EXPECT_EQ(PushMeter(scenario.pushes, 0.001).worst_recovery_time_s(), kNever);
}

TEST(PushMeterTest, AFallIsNoRecoveryFromThePushBeforeItNorFromLaterOnes) {
  Scenario scenario = OneFootScenario();
  for (const double start_s : {1.0, 3.5, 6.5}) PushAt(scenario, start_s, 0.1);
  scenario.expect = {{"fall", {}, {}, true}};
  const RunOutcome outcome =
      OutcomeOf(scenario, 9000, [](Tick tick, WorldTruth& truth, ControlTick&) {
        if (tick >= 5500) truth.p_WB.z() = 0.2;
      });
  EXPECT_TRUE(outcome.pushes[0].figures.recovered);
  EXPECT_FALSE(outcome.pushes[1].figures.recovered) << "calm for 1.9 s, but then it fell";
  EXPECT_EQ(outcome.pushes[1].figures.recovery_time_s, kNever);
  EXPECT_FALSE(outcome.pushes[2].figures.recovered) << "the run was over";
  EXPECT_TRUE(std::isnan(outcome.pushes[2].figures.peak_tilt_rad));
  EXPECT_FALSE(FlagOf(outcome, "recovered"));
}

TEST(PushMeterTest, WithoutAPushThereIsNoRecoveryTime) {
  const RunOutcome outcome =
      RunOf(OneFootScenario(), 2.0, [](double) { return Eigen::Vector3d(0.0, 0.0, 0.5); });
  EXPECT_TRUE(std::isnan(NumberOf(outcome, "recovery_time_s")));
  EXPECT_TRUE(FlagOf(outcome, "recovered")) << "it did not fall either";
}

TEST(PushMeterTest, StepsAndTheirAdjustmentsBelongToThePushBeforeThem) {
  // Hops aside by 3 cm at 0.5 s, by 8 cm at 1.5 s and 2.0 s, by 5 cm at 5.0 s.
  Scenario scenario = OneFootScenario();
  PushAt(scenario, 1.0, 0.1);
  PushAt(scenario, 4.0, 0.1);
  PushAt(scenario, 6.0, 0.1);
  const RunOutcome outcome =
      OutcomeOf(scenario, 8000, [](Tick tick, WorldTruth& truth, ControlTick&) {
        const std::array<Tick, 4> landings{500, 1500, 2000, 5000};
        const std::array<double, 4> steps_m{0.03, 0.08, 0.08, 0.05};
        FootTruth& foot = truth.feet[0];
        for (std::size_t i = 0; i < landings.size(); ++i) {
          if (tick >= landings[i]) foot.p_WF.y() += steps_m[i];
          if (tick < landings[i] - 100 || tick >= landings[i]) continue;
          foot.in_contact = false;
          foot.p_WF.z() = 0.06;
        }
      });
  EXPECT_EQ(outcome.pushes[0].figures.steps_taken, 2);
  EXPECT_NEAR(outcome.pushes[0].figures.max_step_adjustment_m, 0.08, 1e-12);
  EXPECT_EQ(outcome.pushes[1].figures.steps_taken, 1);
  EXPECT_NEAR(outcome.pushes[1].figures.max_step_adjustment_m, 0.05, 1e-12);
  EXPECT_EQ(outcome.pushes[2].figures.steps_taken, 0);
  EXPECT_EQ(outcome.pushes[2].figures.max_step_adjustment_m, 0.0);
  EXPECT_NEAR(NumberOf(outcome, "mean_step_adjustment_m"), 0.07, 1e-12) << "from the first push on";
}

TEST(PushMeterTest, StepsThatCannotBeComparedCountAsWell) {
  // Of two feet only the left one ever stands, and hops: it has no other to step from.
  Scenario scenario = TwoFeetScenario();
  PushAt(scenario, 0.2, 0.1);
  const RunOutcome outcome =
      OutcomeOf(scenario, 2100, [](Tick tick, WorldTruth& truth, ControlTick&) {
        const auto lift = [](FootTruth& foot) {
          foot.in_contact = false;
          foot.p_WF.z() = 0.06;
        };
        lift(truth.feet[1]);
        if (tick % 500 >= 400) lift(truth.feet[0]);
      });
  EXPECT_EQ(outcome.pushes[0].figures.steps_taken, 4);
  EXPECT_EQ(outcome.pushes[0].figures.max_step_adjustment_m, 0.0);
}

}  // namespace
}  // namespace sidestep::push_meter_test
