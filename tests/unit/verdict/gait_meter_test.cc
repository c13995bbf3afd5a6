// SPDX-License-Identifier: BSD-3-Clause
// What a gait came to, of sequences whose figures are known by hand.
#include "sim/verdict/gait_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "models/support/gravity.h"
#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::gait_meter_test {
namespace {

constexpr double kWeight_N = kTestMass_kg * kGravity_mps2;

// A foot that comes down every `period` ticks, first at `first`, and stands for `stance` of them.
// It stands from the start on until its first swing.
struct Beat {
  Tick first;
  Tick period;
  Tick stance;
  bool StandsAt(Tick tick) const {
    if (tick < first) return tick < first - (period - stance);
    return (tick - first) % period < stance;
  }
  Tick LandingsBefore(Tick tick) const { return tick < first ? 0 : (tick - first) / period + 1; }
};

void Swing(FootTruth& foot) {
  foot.in_contact = false;
  foot.f_F_W.setZero();
  foot.p_WF.z() += 0.05;
}

// Two feet that each advance by `stride_m` a beat, the CoM at the mean speed of that.
Script Stepping(const Beat& left, const Beat& right, double stride_m) {
  return [=](Tick tick, WorldTruth& truth, ControlTick&) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Beat& beat = i == 0 ? left : right;
      truth.feet[i].p_WF.x() = stride_m * static_cast<double>(beat.LandingsBefore(tick));
      if (!beat.StandsAt(tick)) Swing(truth.feet[i]);
    }
    truth.p_WC.x() = stride_m / static_cast<double>(left.period) * static_cast<double>(tick);
  };
}

Scenario ScenarioOf(GaitType type) {
  Scenario scenario = TwoFeetScenario();
  scenario.gait[0].type = type;
  return scenario;
}

GaitFigures FiguresOf(const RunOutcome& outcome, std::size_t gait = 0) {
  return outcome.gaits.at(gait).figures;
}

TEST(GaitMeterTest, WalkHasItsSpeedStepsAndNoFlight) {
  // Each foot lands every 1.0 s and stands for 0.7 s; half a period apart, 0.3 m a stride.
  const RunOutcome outcome = OutcomeOf(ScenarioOf(GaitType::kWalk), 6100,
                                       Stepping({1000, 1000, 700}, {1500, 1000, 700}, 0.3));
  const GaitFigures figures = FiguresOf(outcome);
  EXPECT_EQ(figures.strides, 5) << "the left foot's: at 1, 2, 3, 4, 5 and 6 s";
  EXPECT_DOUBLE_EQ(figures.from_s, 1.0);
  EXPECT_DOUBLE_EQ(figures.to_s, 6.0);
  EXPECT_NEAR(figures.speed_mps, 0.3, 1e-12);
  EXPECT_NEAR(figures.step_length_m, 0.15, 1e-12);
  EXPECT_NEAR(figures.step_frequency_hz, 2.0, 1e-12);
  EXPECT_NEAR(figures.duty_factor, 0.7, 1e-12);
  EXPECT_EQ(figures.flight_fraction, 0.0);
  EXPECT_EQ(NumberOf(outcome, "gait_speed_mps"), figures.speed_mps);
  EXPECT_EQ(NumberOf(outcome, "step_length_m"), figures.step_length_m);
  EXPECT_EQ(NumberOf(outcome, "step_frequency_hz"), figures.step_frequency_hz);
  EXPECT_EQ(NumberOf(outcome, "duty_factor"), figures.duty_factor);
  EXPECT_EQ(NumberOf(outcome, "walk_flight_fraction"), 0.0);
  EXPECT_TRUE(std::isnan(NumberOf(outcome, "run_flight_fraction"))) << "nobody is to run";
}

TEST(GaitMeterTest, RunFliesForWhatItsFeetLeaveOver) {
  // 0.15 s on each foot of a stride of 0.5 s: flight is 0.1 s, twice a stride.
  const RunOutcome outcome =
      OutcomeOf(ScenarioOf(GaitType::kRun), 4000, Stepping({500, 500, 150}, {750, 500, 150}, 0.8));
  EXPECT_NEAR(FiguresOf(outcome).duty_factor, 0.3, 1e-12);
  EXPECT_NEAR(FiguresOf(outcome).flight_fraction, 0.4, 1e-12);
  EXPECT_NEAR(FiguresOf(outcome).speed_mps, 1.6, 1e-12);
  EXPECT_NEAR(FiguresOf(outcome).step_length_m, 0.4, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "run_flight_fraction"), 0.4, 1e-12);
  EXPECT_TRUE(std::isnan(NumberOf(outcome, "walk_flight_fraction")));
}

TEST(GaitMeterTest, StepLengthIsOfTheFeetAndSpeedOfTheCom) {
  const Script feet = Stepping({500, 500, 150}, {750, 500, 150}, 0.8);
  const RunOutcome outcome = OutcomeOf(ScenarioOf(GaitType::kRun), 4000,
                                       [&](Tick tick, WorldTruth& truth, ControlTick& control) {
                                         feet(tick, truth, control);
                                         truth.p_WC.x() = 0.0;
                                         truth.p_WC.y() = -0.001 * static_cast<double>(tick);
                                       });
  EXPECT_NEAR(FiguresOf(outcome).speed_mps, 1.0, 1e-12) << "whichever way";
  EXPECT_NEAR(FiguresOf(outcome).step_length_m, 0.4, 1e-12);
}

// Walks until 3 s, then runs, each as in the tests above.
RunOutcome WalkToRun(Tick end) {
  Scenario scenario = ScenarioOf(GaitType::kWalk);
  scenario.gait.resize(2);
  scenario.gait[1].type = GaitType::kRun;
  scenario.gait[1].start_s = 2.8;
  const Script walk = Stepping({1000, 1000, 700}, {1500, 1000, 700}, 0.3);
  const Script run = Stepping({3000, 500, 150}, {3250, 500, 150}, 0.8);
  return OutcomeOf(scenario, end, [=](Tick tick, WorldTruth& truth, ControlTick& control) {
    (tick < 3000 ? walk : run)(tick, truth, control);
  });
}

TEST(GaitMeterTest, EachGaitIsMeasuredFromItsFirstStepToTheNextGaitsFirst) {
  const RunOutcome outcome = WalkToRun(6100);
  ASSERT_EQ(outcome.gaits.size(), 2u);
  EXPECT_EQ(outcome.gaits[0].gait.type, GaitType::kWalk);
  EXPECT_EQ(FiguresOf(outcome, 0).strides, 2);
  EXPECT_DOUBLE_EQ(FiguresOf(outcome, 0).to_s, 3.0) << "the step that begins the run ends the walk";
  EXPECT_NEAR(FiguresOf(outcome, 0).duty_factor, 0.7, 1e-12);
  EXPECT_EQ(FiguresOf(outcome, 0).flight_fraction, 0.0);
  EXPECT_EQ(outcome.gaits[1].gait.start_s, 2.8);
  EXPECT_EQ(FiguresOf(outcome, 1).strides, 6);
  EXPECT_DOUBLE_EQ(FiguresOf(outcome, 1).from_s, 3.0);
  EXPECT_NEAR(FiguresOf(outcome, 1).flight_fraction, 0.4, 1e-12);
  EXPECT_EQ(NumberOf(outcome, "walk_flight_fraction"), 0.0);
  EXPECT_NEAR(NumberOf(outcome, "run_flight_fraction"), 0.4, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "duty_factor"), 0.3, 1e-12) << "of the last gait";
}

// Share of flight of a walk of 6 s whose feet are both off the ground from tick `from` to `to`.
double WalkFlightWithBothFeetUp(Tick from, Tick to) {
  const Script walk = Stepping({1000, 1000, 700}, {1500, 1000, 700}, 0.3);
  const RunOutcome outcome = OutcomeOf(ScenarioOf(GaitType::kWalk), 6000,
                                       [&](Tick tick, WorldTruth& truth, ControlTick& control) {
                                         walk(tick, truth, control);
                                         if (tick < from || tick >= to) return;
                                         for (FootTruth& foot : truth.feet) Swing(foot);
                                       });
  return NumberOf(outcome, "walk_flight_fraction");
}

TEST(GaitMeterTest, FlightInAWalkCountsOutsideOfWholeStridesToo) {
  // A hop of both feet in the first second, before any whole stride: 0.1 s of 6 s.
  EXPECT_NEAR(WalkFlightWithBothFeetUp(200, 300), 0.1 / 6.0, 1e-12);
}

TEST(GaitMeterTest, ABreakOfStanceOfUpTo10MillisecondsIsNoFlightAndALongerOneCountsWhole) {
  EXPECT_EQ(WalkFlightWithBothFeetUp(200, 201), 0.0);
  EXPECT_EQ(WalkFlightWithBothFeetUp(200, 203), 0.0);
  EXPECT_EQ(WalkFlightWithBothFeetUp(200, 210), 0.0);
  EXPECT_NEAR(WalkFlightWithBothFeetUp(200, 211), 0.011 / 6.0, 1e-12);
  EXPECT_NEAR(WalkFlightWithBothFeetUp(200, 220), 0.020 / 6.0, 1e-12);
  EXPECT_NEAR(WalkFlightWithBothFeetUp(5995, 6001), 0.005 / 6.0, 1e-12) << "nobody came back";
}

TEST(GaitMeterTest, FlightCountsFromTheFirstTickThatAFootBearsLoad) {
  EXPECT_EQ(WalkFlightWithBothFeetUp(0, 1), 0.0);
  EXPECT_EQ(WalkFlightWithBothFeetUp(0, 100), 0.0) << "it is set down";
}

TEST(GaitMeterTest, ABreakOfStanceIsNoneOfTheDutyFactor) {
  const Script walk = Stepping({1000, 1000, 700}, {1500, 1000, 700}, 0.3);
  const RunOutcome outcome = OutcomeOf(ScenarioOf(GaitType::kWalk), 6100,
                                       [&](Tick tick, WorldTruth& truth, ControlTick& control) {
                                         walk(tick, truth, control);
                                         if (tick % 100 < 5) truth.feet[0].f_F_W.setZero();
                                       });
  EXPECT_NEAR(FiguresOf(outcome).duty_factor, 0.7, 0.006) << "but for where it lands or lifts off";
}

TEST(GaitMeterTest, StandHasNoFiguresAndIsNoLastGait) {
  Scenario scenario = ScenarioOf(GaitType::kWalk);
  scenario.gait.resize(2);
  scenario.gait[1].start_s = 5.8;
  const RunOutcome outcome = OutcomeOf(scenario, 9000,
                                       [walk = Stepping({1000, 1000, 700}, {1500, 1000, 700}, 0.3)](
                                           Tick tick, WorldTruth& truth, ControlTick& control) {
                                         walk(std::min<Tick>(tick, 6000), truth, control);
                                         for (FootTruth& foot : truth.feet) {
                                           if (tick >= 6200)
                                             foot = StandingTruth(TwoFeetScenario()).feet[0];
                                         }
                                       });
  EXPECT_EQ(FiguresOf(outcome, 1).strides, 0);
  EXPECT_TRUE(std::isnan(FiguresOf(outcome, 1).speed_mps));
  EXPECT_NEAR(NumberOf(outcome, "gait_speed_mps"), 0.3, 1e-12);
  EXPECT_TRUE(
      std::isnan(NumberOf(OutcomeOf(OneFootScenario(), 500, [](auto...) {}), "gait_speed_mps")));
}

// A hop every 0.4 s, 0.2 s on the ground with a peak of 2.5 weights, 0.2 m each; two motors turn at
// 2 rad/s with 6 N m each, the first with the torque, the second against it, in the stance.
RunOutcome Hops(double hop_m) {
  Scenario scenario = OneFootScenario();
  scenario.gait[0].type = GaitType::kHop;
  Judge judge = JudgeOf(scenario, {{"hip"}, {"knee"}});
  Watch(judge, scenario, 2500, [=](Tick tick, WorldTruth& truth, ControlTick&) {
    const Beat beat{400, 400, 200};
    FootTruth& foot = truth.feet[0];
    foot.p_WF.x() = hop_m * static_cast<double>(beat.LandingsBefore(tick));
    foot.f_F_W.z() = tick % 400 == 100 ? 2.5 * kWeight_N : kWeight_N;
    if (tick == 350) foot.f_F_W.z() = 4.0 * kWeight_N;  // before the first whole stride
    if (!beat.StandsAt(tick)) Swing(foot);
    truth.p_WC.x() = hop_m / 400.0 * static_cast<double>(tick);
    truth.joint_position = Eigen::Vector2d::Zero();
    const bool works = beat.StandsAt(tick - 1);  // in the step that led here
    truth.joint_torque_Nm = Eigen::Vector2d(6.0, 6.0) * (works ? 1.0 : 0.0);
    truth.joint_velocity = Eigen::Vector2d(2.0, -2.0);
  });
  return judge.Conclude();
}

TEST(GaitMeterTest, CostOfTransportIsThePositiveWorkOverWeightTimesWay) {
  // 12 W for 0.2 s are 2.4 J a hop of 0.2 m: 2.4 / (98.1 x 0.2). The knee's -12 W give nothing
  // back.
  const RunOutcome outcome = Hops(0.2);
  EXPECT_EQ(FiguresOf(outcome).strides, 5);
  EXPECT_NEAR(FiguresOf(outcome).cost_of_transport, 2.4 / (kWeight_N * 0.2), 1e-9);
  EXPECT_EQ(NumberOf(outcome, "cost_of_transport"), FiguresOf(outcome).cost_of_transport);
  EXPECT_NEAR(FiguresOf(outcome).duty_factor, 0.5, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "run_flight_fraction"), 0.5, 1e-12);
}

TEST(GaitMeterTest, WithoutAWayOrWithoutMotorsThereIsNoCostOfTransport) {
  EXPECT_TRUE(std::isnan(FiguresOf(Hops(0.005)).cost_of_transport));
  EXPECT_NEAR(FiguresOf(Hops(0.005)).step_length_m, 0.005, 1e-12);
  const RunOutcome unmotored = OutcomeOf(ScenarioOf(GaitType::kWalk), 6000,
                                         Stepping({1000, 1000, 700}, {1500, 1000, 700}, 0.3));
  EXPECT_TRUE(std::isnan(FiguresOf(unmotored).cost_of_transport));
}

TEST(GaitMeterTest, PeakForceIsOfOneFootInTheWholeStrides) {
  EXPECT_NEAR(FiguresOf(Hops(0.2)).max_ground_force_ratio, 2.5, 1e-12);
  EXPECT_NEAR(NumberOf(Hops(0.2), "max_ground_force_ratio"), 2.5, 1e-12);
}

TEST(GaitMeterTest, AFallEndsTheMeasuring) {
  const Script walk = Stepping({1000, 1000, 700}, {1500, 1000, 700}, 0.3);
  const RunOutcome outcome = OutcomeOf(ScenarioOf(GaitType::kWalk), 6000,
                                       [&](Tick tick, WorldTruth& truth, ControlTick& control) {
                                         walk(tick, truth, control);
                                         if (tick >= 2900) truth.p_WB.z() = 0.1;
                                       });
  EXPECT_EQ(FiguresOf(outcome).strides, 1);
}

}  // namespace
}  // namespace sidestep::gait_meter_test
