// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/path_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::path_meter_test {
namespace {

using Motion = std::function<void(double time_s, ComReference& reference, WorldTruth& truth)>;

// 500 Hz for 4 s.
PathFigures FiguresOf(const Scenario& scenario, const Motion& motion,
                      std::optional<Tick> push_end = {}) {
  PathMeter meter(scenario);
  for (Tick tick = 0; tick <= 4000; tick += 2) {
    WorldTruth truth;
    ComReference reference;
    motion(0.001 * static_cast<double>(tick), reference, truth);
    meter.Add(tick, truth, reference);
  }
  return meter.Conclude(push_end);
}

// Walks along x at 0.5 m/s while swaying; the truth is `lag_s` late.
Motion LateWalk(double lag_s) {
  return [=](double time_s, ComReference& reference, WorldTruth& truth) {
    const auto place = [](double at_s) {
      return Eigen::Vector3d(0.5 * at_s, 0.03 * std::sin(2.0 * std::numbers::pi * at_s), 0.5);
    };
    reference.p_WC = place(time_s);
    truth.p_WC = place(time_s - lag_s);
  };
}

TEST(PathMeterTest, LatenessIsNoErrorOnThePathButIsOneAgainstAPathThatFollows) {
  Scenario scenario = OneFootScenario();
  EXPECT_LT(FiguresOf(scenario, LateWalk(0.1)).final_path_error_m, 1e-4);
  scenario.control.planner.follow = FollowMode::kCapturePoint;
  EXPECT_NEAR(FiguresOf(scenario, LateWalk(0.1)).final_path_error_m, 0.053, 0.003);
}

TEST(PathMeterTest, LateralOffsetIsTheErrorWhateverFollows) {
  const Motion offset = [](double time_s, ComReference& reference, WorldTruth& truth) {
    reference.p_WC = {0.5 * time_s, 0.0, 0.5};
    truth.p_WC = {0.5 * time_s, time_s > 1.0 && time_s < 2.0 ? 0.12 : 0.04, 0.7};
  };
  Scenario scenario = OneFootScenario();
  for (const FollowMode follow : {FollowMode::kPath, FollowMode::kCapturePoint}) {
    scenario.control.planner.follow = follow;
    const PathFigures figures = FiguresOf(scenario, offset);
    EXPECT_NEAR(figures.final_path_error_m, 0.04, 1e-12);
    EXPECT_NEAR(figures.max_path_error_m, 0.12, 1e-12);
    EXPECT_TRUE(std::isnan(figures.recovery_time_s)) << "there was no push";
  }
}

TEST(PathMeterTest, SpeedErrorIsAMeanOverTheGaitCycle) {
  Scenario scenario = OneFootScenario();
  scenario.gait[0].type = GaitType::kHop;
  scenario.gait[0].stance_s = 0.15;
  scenario.gait[0].flight_s = 0.25;
  const PathFigures figures =
      FiguresOf(scenario, [](double time_s, ComReference& reference, WorldTruth& truth) {
        reference.v_WC.x() = 0.5;
        // A ripple of the cycle's period cancels; a steady 0.03 m/s to the left stays.
        truth.v_WC = {0.5 + 0.4 * std::sin(2.0 * std::numbers::pi * time_s / 0.4), 0.03, 1.0};
      });
  EXPECT_NEAR(figures.final_speed_error_mps, 0.03, 1e-10);
}

TEST(PathMeterTest, RecoveryIsTheLastReturnNotTheFirst) {
  const Motion pushed_twice = [](double time_s, ComReference&, WorldTruth& truth) {
    const bool is_away = (time_s > 1.0 && time_s < 1.5) || (time_s > 2.0 && time_s < 2.2);
    truth.p_WC.y() = is_away ? 0.2 : 0.01;
  };
  const Scenario scenario = OneFootScenario();
  EXPECT_NEAR(FiguresOf(scenario, pushed_twice, 1100).recovery_time_s, 1.1, 0.003);
  EXPECT_NEAR(FiguresOf(scenario, pushed_twice, 3000).recovery_time_s, 0.0, 1e-12);
}

TEST(PathMeterTest, RecoveryThatDoesNotLastIsInfinite) {
  const Motion never_back = [](double time_s, ComReference&, WorldTruth& truth) {
    truth.p_WC.y() = time_s > 3.9 ? 0.06 : 0.0;
  };
  EXPECT_EQ(FiguresOf(OneFootScenario(), never_back, 1000).recovery_time_s, INFINITY);
  EXPECT_EQ(FiguresOf(OneFootScenario(), LateWalk(0.0), 5000).recovery_time_s, INFINITY)
      << "the push outlasted the run";
}

TEST(PathMeterTest, RunningAwayAlongThePathIsNoRecovery) {
  const Motion too_fast = [](double time_s, ComReference& reference, WorldTruth& truth) {
    reference.p_WC.x() = 0.5 * time_s;
    reference.v_WC.x() = 0.5;
    truth.p_WC.x() = 0.5 * time_s;
    truth.v_WC.x() = 0.7;
  };
  EXPECT_EQ(FiguresOf(OneFootScenario(), too_fast, 1000).recovery_time_s, INFINITY);
}

TEST(PathMeterTest, GaitCycleHasEveryFootStepOnce) {
  GaitParams gait;
  gait.swing_s = 0.6;
  gait.double_support_s = 0.2;
  gait.stance_s = 0.15;
  gait.flight_s = 0.1;
  const auto cycle_s = [&](GaitType type, std::size_t num_feet) {
    gait.type = type;
    return GaitCycle_s(gait, num_feet);
  };
  EXPECT_DOUBLE_EQ(cycle_s(GaitType::kWalk, 2), 1.6);
  EXPECT_DOUBLE_EQ(cycle_s(GaitType::kRun, 2), 0.5);
  EXPECT_DOUBLE_EQ(cycle_s(GaitType::kHop, 1), 0.25);
  EXPECT_DOUBLE_EQ(cycle_s(GaitType::kStand, 2), 1.0);
}

TEST(PathMeterTest, NothingSeenIsNotMeasured) {
  const PathFigures figures = PathMeter(OneFootScenario()).Conclude({});
  EXPECT_TRUE(std::isnan(figures.final_path_error_m));
  EXPECT_TRUE(std::isnan(figures.max_path_error_m));
}

}  // namespace
}  // namespace sidestep::path_meter_test
