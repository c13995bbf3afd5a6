// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/path_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "models/support/require.h"
#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::path_meter_test {
namespace {

using Motion = std::function<void(double time_s, WorldTruth& truth)>;

struct Figures {
  PathSample last;
  double max_error_m;
};

PathMeter MeterOf(const Scenario& scenario) {
  return {NominalOf(scenario), AskedGaitOf(scenario), scenario.control.rate_hz};
}

// 500 Hz for 6 s.
Figures FiguresOf(const Scenario& scenario, const Motion& motion) {
  PathMeter meter = MeterOf(scenario);
  for (Tick tick = 0; tick <= 6000; tick += 2) {
    WorldTruth truth;
    motion(0.001 * static_cast<double>(tick), truth);
    meter.Add(tick, truth);
  }
  return {meter.last(), meter.max_error_m()};
}

// Walks at 0.125 m/s along x, swaying by 3 cm.
Scenario WalkScenario() {
  Scenario scenario = TwoFeetScenario();
  scenario.control.planner.sway.share = 0.4;
  return scenario;
}

// The nominal motion itself, `late_s` late (from the start on it stands), `aside_m` to the left.
Motion Nominal(const Scenario& scenario, double late_s, double aside_m) {
  return [nominal = NominalOf(scenario), late_s, aside_m](double time_s, WorldTruth& truth) {
    const ComReference at = nominal.ComAt(TickAt(std::max(0.0, time_s - late_s), 0.001));
    truth.p_WC = at.p_WC + Eigen::Vector3d(0.0, aside_m, 0.0);
    truth.v_WC = at.v_WC;
  };
}

TEST(PathMeterTest, NominalMotionIsOnItsPathAtItsSpeed) {
  const Scenario scenario = WalkScenario();
  const Figures figures = FiguresOf(scenario, Nominal(scenario, 0.0, 0.0));
  EXPECT_LT(figures.max_error_m, 2e-5) << "chords of 10 ms";
  EXPECT_LT(figures.last.drift_m, 2e-5);
  EXPECT_LT(figures.last.wander_m, 2e-5);
  EXPECT_LT(figures.last.speed_error_mps, 1e-4);
  EXPECT_NEAR(figures.last.speed_mps, 0.125, 1e-3);
}

TEST(PathMeterTest, LatenessIsNoErrorHoweverLargeItGrows) {
  // 3.5 s are more than two gait cycles: the lag along the line is 0.44 m.
  const Scenario scenario = WalkScenario();
  for (const double late_s : {0.1, 0.7, 3.5}) {
    const Figures figures = FiguresOf(scenario, Nominal(scenario, late_s, 0.0));
    EXPECT_LT(figures.max_error_m, 2e-5) << late_s;
  }
}

TEST(PathMeterTest, WhatThePlannerFollowsDoesNotMatter) {
  Scenario scenario = WalkScenario();
  for (const FollowMode follow : {FollowMode::kPath, FollowMode::kCapturePoint}) {
    scenario.control.planner.follow = follow;
    EXPECT_LT(FiguresOf(scenario, Nominal(scenario, 0.3, 0.0)).max_error_m, 2e-5);
  }
}

TEST(PathMeterTest, LateralOffsetIsTheErrorAndItsMeanTheDrift) {
  Scenario scenario = TwoFeetScenario();  // without sway: along y = 0
  const Motion walk = Nominal(scenario, 0.0, 0.0);
  const Figures figures = FiguresOf(scenario, [&](double time_s, WorldTruth& truth) {
    walk(time_s, truth);
    truth.p_WC.y() = time_s > 1.0 && time_s < 2.0 ? 0.12 : 0.04;
    truth.p_WC.z() = 0.7;
  });
  EXPECT_NEAR(figures.last.error_m, 0.04, 1e-12);
  EXPECT_NEAR(figures.max_error_m, 0.12, 1e-12);
  EXPECT_NEAR(figures.last.drift_m, 0.04, 1e-12);
  EXPECT_NEAR(figures.last.wander_m, 0.0, 1e-12);
}

TEST(PathMeterTest, DriftIsTheMeanOffsetOfTheLastCycleAndWanderWhatIsLeft) {
  // A stand, whose cycle is 1 s; the offset jumps from 0 to 0.2 m a quarter second before the end.
  const Figures figures = FiguresOf(OneFootScenario(), [](double time_s, WorldTruth& truth) {
    truth.p_WC.y() = time_s > 5.75 ? 0.2 : 0.0;
  });
  EXPECT_NEAR(figures.last.drift_m, 0.05, 1e-3);
  EXPECT_NEAR(figures.last.wander_m, 0.15, 1e-3);
  EXPECT_NEAR(figures.last.speed_mps, 0.2, 1e-3) << "0.2 m in the last second";
}

TEST(PathMeterTest, RobotThatStopsStaysOnThePathAndItsSpeedTells) {
  const Scenario scenario = TwoFeetScenario();
  const Motion walk = Nominal(scenario, 0.0, 0.0);
  const Figures figures = FiguresOf(scenario, [&](double time_s, WorldTruth& truth) {
    walk(std::min(time_s, 2.0), truth);
    truth.v_WC.setZero();
  });
  EXPECT_LT(figures.max_error_m, 2e-5);
  EXPECT_NEAR(figures.last.speed_mps, 0.0, 1e-12);
  EXPECT_NEAR(figures.last.speed_error_mps, 0.125, 1e-3);
}

TEST(PathMeterTest, PaceIsComparedWhereTheRobotIs) {
  // Walks until 3.2 s and stands; 1.5 s late it still walks at 4 s, while the clock has it stand.
  Scenario scenario = WalkScenario();
  scenario.duration_s = 6.0;
  scenario.gait.resize(2);
  scenario.gait[1].type = GaitType::kStand;
  scenario.gait[1].start_s = 4.0;
  const double end_s = 6.0;
  const Figures late = FiguresOf(scenario, Nominal(scenario, 1.5, 0.0));
  ASSERT_GT(late.last.speed_mps, 0.05) << "at " << end_s << " s";
  EXPECT_LT(late.last.pace_error_mps, 0.01);
  EXPECT_GT(late.last.speed_error_mps, 0.05);
  // At half the speed from the start on, it is not late but slow.
  const Figures slow = FiguresOf(
      TwoFeetScenario(), [walk = NominalOf(TwoFeetScenario())](double time_s, WorldTruth& truth) {
        truth.p_WC = walk.ComAt(TickAt(0.5 * time_s, 0.001)).p_WC;
      });
  EXPECT_NEAR(slow.last.pace_error_mps, 0.0625, 2e-3);
}

TEST(PathMeterTest, RobotThatRunsBeyondThePathsStartIsOffIt) {
  const Scenario scenario = TwoFeetScenario();
  const Figures figures =
      FiguresOf(scenario, [](double time_s, WorldTruth& truth) { truth.p_WC.x() = -0.1 * time_s; });
  EXPECT_NEAR(figures.last.error_m, 0.6, 2e-3) << "its spline swings back by 1 mm to set off";
}

TEST(PathMeterTest, SpeedErrorIsAMeanOverTheGaitCycle) {
  Scenario scenario = OneFootScenario();
  scenario.gait[0].type = GaitType::kHop;
  scenario.gait[0].stance_s = 0.15;
  scenario.gait[0].flight_s = 0.25;
  const Figures figures = FiguresOf(scenario, [](double time_s, WorldTruth& truth) {
    // A ripple of the cycle's period cancels; a steady 0.03 m/s to the left stays.
    truth.p_WC.x() = 0.02 * std::sin(2.0 * std::numbers::pi * time_s / 0.4);
    truth.p_WC.y() = 0.03 * time_s;
  });
  EXPECT_NEAR(figures.last.speed_error_mps, 0.03, 1e-10);
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
  const Scenario scenario = OneFootScenario();
  const PathMeter meter = MeterOf(scenario);
  EXPECT_TRUE(std::isnan(meter.last().error_m));
  EXPECT_TRUE(std::isnan(meter.last().drift_m));
  EXPECT_TRUE(std::isnan(meter.max_error_m()));
}

TEST(PathMeterTest, SamplesAtTheControlRateOnly) {
  const Scenario scenario = OneFootScenario();
  PathMeter meter = MeterOf(scenario);
  EXPECT_TRUE(meter.Samples(0));
  EXPECT_FALSE(meter.Samples(1));
  EXPECT_TRUE(meter.Samples(2));
  EXPECT_THROW(meter.Add(1, WorldTruth{}), ContractViolation);
}

TEST(PathLineTest, OfPointsAsNearItIsTheOneNearestToNow) {
  Scenario scenario = OneFootScenario();  // stands at the origin
  const PathLine line(NominalOf(scenario));
  EXPECT_NEAR(line.NearestTo({0.1, 0.0}, 500.0, 1000.0, 700).tick, 700.0, 1e-9);
  EXPECT_NEAR(line.NearestTo({0.1, 0.0}, 500.0, 100.0, 5000).tick, 610.0, 10.0) << "within reach";
}

TEST(PathLineTest, IsHeldAtItsEnds) {
  const Scenario scenario = TwoFeetScenario();
  const NominalMotion nominal = NominalOf(scenario);
  const PathLine line(nominal);
  EXPECT_EQ(line.At(-100.0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_NEAR(line.At(1e9).x(), nominal.ComAt(nominal.end_tick()).p_WC.x(), 2e-3);
  EXPECT_NEAR(line.At(2005.0).x(), nominal.ComAt(2005).p_WC.x(), 1e-5);
}

}  // namespace
}  // namespace sidestep::path_meter_test
