// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "models/support/require.h"
#include "sim/verdict/metrics.h"
#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::judge_test {
namespace {

void Nothing(Tick, WorldTruth&, ControlTick&) {}

void SinkAfterTick100(Tick tick, WorldTruth& truth, ControlTick&) {
  if (tick > 100) truth.p_WB.z() = 0.29;  // below half of 0.6 m
}

Expectation ExpectFlag(const std::string& metric, bool is) { return {metric, {}, {}, is}; }

std::vector<std::string> KindsOf(const RunOutcome& outcome) {
  std::vector<std::string> kinds;
  for (const Reason& one : outcome.verdict.reasons) kinds.push_back(one.kind);
  return kinds;
}

using Kinds = std::vector<std::string>;

TEST(JudgeTest, RobotThatStandsPasses) {
  const RunOutcome outcome = OutcomeOf(OneFootScenario(), 1000, Nothing);
  EXPECT_EQ(outcome.verdict.verdict_class, VerdictClass::kPass);
  EXPECT_EQ(KindsOf(outcome), Kinds{});
  EXPECT_FALSE(FlagOf(outcome, "fall"));
  EXPECT_FALSE(FlagOf(outcome, "slip"));
  EXPECT_DOUBLE_EQ(NumberOf(outcome, "min_base_height_m"), 0.6);
  EXPECT_DOUBLE_EQ(NumberOf(outcome, "min_base_height_ratio"), 1.0);
  EXPECT_DOUBLE_EQ(NumberOf(outcome, "max_base_height_ratio"), 1.0);
}

TEST(JudgeTest, MeasuresExactlyTheKnownMetricsWithTheirTypes) {
  const RunOutcome outcome = OutcomeOf(OneFootScenario(), 10, Nothing);
  std::set<std::string> measured;
  for (const auto& [name, value] : outcome.metrics) {
    measured.insert(name);
    const MetricInfo* info = FindMetric(name);
    ASSERT_NE(info, nullptr) << name;
    EXPECT_EQ(info->is_bool, std::holds_alternative<bool>(value)) << name;
  }
  std::set<std::string> known;
  for (const MetricInfo& info : KnownMetrics()) known.insert(std::string(info.name));
  EXPECT_EQ(measured, known);
}

TEST(JudgeTest, SinkingBelowTheRatioIsAFallAndEndsTheRunHalfASecondLater) {
  const Scenario scenario = OneFootScenario();
  Judge judge = JudgeOf(scenario);
  EXPECT_EQ(Watch(judge, scenario, 5000, SinkAfterTick100), 601);
  const RunOutcome outcome = judge.Conclude();
  EXPECT_TRUE(FlagOf(outcome, "fall"));
  EXPECT_EQ(outcome.verdict.verdict_class, VerdictClass::kFail);
  EXPECT_EQ(KindsOf(outcome), Kinds{"FALL"});
  EXPECT_EQ(outcome.verdict.reasons[0].text, "base height 0.290 m is below 0.300 m");
  EXPECT_DOUBLE_EQ(NumberOf(outcome, "fall_time_s"), 0.101);
}

TEST(JudgeTest, TiltBeyondTheBoundIsAFall) {
  const auto tilt_by = [](double angle_rad) {
    return OutcomeOf(OneFootScenario(), 200, [=](Tick tick, WorldTruth& truth, ControlTick&) {
      truth.q_WB = Eigen::AngleAxisd(angle_rad * static_cast<double>(tick) / 200.0,
                                     Eigen::Vector3d(1.0, 1.0, 0.0).normalized());
    });
  };
  EXPECT_FALSE(FlagOf(tilt_by(0.99), "fall"));
  EXPECT_TRUE(FlagOf(tilt_by(1.01), "fall"));
  EXPECT_NEAR(NumberOf(tilt_by(0.99), "max_tilt_rad"), 0.99, 1e-12);
}

TEST(JudgeTest, TurningAboutTheVerticalIsNoFall) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 200, [](Tick, WorldTruth& truth, ControlTick&) {
        truth.q_WB = Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitZ());
      });
  EXPECT_FALSE(FlagOf(outcome, "fall"));
}

TEST(JudgeTest, BodyOnTheGroundIsAFall) {
  const RunOutcome outcome = OutcomeOf(
      OneFootScenario(), 200,
      [](Tick tick, WorldTruth& truth, ControlTick&) { truth.body_touches_ground = tick == 150; });
  EXPECT_DOUBLE_EQ(NumberOf(outcome, "fall_time_s"), 0.15);
  EXPECT_EQ(KindsOf(outcome), Kinds{"FALL"});
}

TEST(JudgeTest, CentroidalPlantFallsByItsCom) {
  Scenario scenario = OneFootScenario();
  scenario.plant = Plant::kCentroidal;
  const auto at_height = [&](double height_m) {
    return OutcomeOf(scenario, 50, [=](Tick, WorldTruth& truth, ControlTick&) {
      truth.p_WC.z() = truth.p_WB.z() = height_m;
    });
  };
  EXPECT_FALSE(FlagOf(at_height(0.26), "fall")) << "above half of com_height_m = 0.5 m";
  EXPECT_TRUE(FlagOf(at_height(0.24), "fall"));
}

TEST(JudgeTest, ExpectedFallPassesAndItsAbsenceFails) {
  Scenario scenario = OneFootScenario();
  scenario.expect = {ExpectFlag("fall", true)};
  EXPECT_EQ(OutcomeOf(scenario, 200, SinkAfterTick100).verdict.verdict_class, VerdictClass::kPass);
  const RunOutcome stands = OutcomeOf(scenario, 200, Nothing);
  EXPECT_EQ(KindsOf(stands), Kinds{"EXPECTATION"});
  EXPECT_EQ(stands.verdict.reasons[0].text, "fall is false, expected true");
}

TEST(JudgeTest, UnwantedFallIsSaidOnce) {
  Scenario scenario = OneFootScenario();
  scenario.expect = {ExpectFlag("fall", false)};
  const RunOutcome outcome = OutcomeOf(scenario, 200, SinkAfterTick100);
  EXPECT_EQ(KindsOf(outcome), Kinds{"FALL"});
  EXPECT_FALSE(outcome.verdict.expectations[0].pass);
}

void SlideSixCentimetres(Tick tick, WorldTruth& truth, ControlTick&) {
  truth.feet[0].p_WF.y() = 0.06 * static_cast<double>(tick) / 200.0;
}

TEST(JudgeTest, SlideBeyondTheBoundIsASlip) {
  Scenario scenario = OneFootScenario();
  const RunOutcome outcome = OutcomeOf(scenario, 200, SlideSixCentimetres);
  EXPECT_EQ(KindsOf(outcome), Kinds{"SLIP"});
  // The anchor is taken after 10 ms.
  EXPECT_NEAR(NumberOf(outcome, "max_slip_m"), 0.06 * 190.0 / 200.0, 1e-12);
  scenario.expect = {ExpectFlag("slip", true)};
  EXPECT_EQ(OutcomeOf(scenario, 200, SlideSixCentimetres).verdict.verdict_class,
            VerdictClass::kPass);
  scenario.verdict.max_slip_m = 0.07;
  EXPECT_FALSE(FlagOf(OutcomeOf(scenario, 200, SlideSixCentimetres), "slip"));
}

TEST(JudgeTest, FeetOfAFallenRobotMaySlideAndItsSolverMayFail) {
  Scenario scenario = OneFootScenario();
  scenario.expect = {ExpectFlag("fall", true)};
  const RunOutcome outcome =
      OutcomeOf(scenario, 500, [](Tick tick, WorldTruth& truth, ControlTick& control) {
        SinkAfterTick100(tick, truth, control);
        if (tick <= 101) return;
        truth.feet[0].p_WF.x() = 0.5;
        control.mpc.status = SolveStatus::kInfeasible;
      });
  EXPECT_EQ(KindsOf(outcome), Kinds{});
}

// Fails the solves of the first `count` control ticks.
RunOutcome WithFailedSolves(int count) {
  return OutcomeOf(OneFootScenario(), 100, [=](Tick tick, WorldTruth&, ControlTick& control) {
    if (tick / kControlPeriod >= count) return;
    control.mpc.status = SolveStatus::kIterationLimit;
    control.mpc.fell_back = true;
  });
}

TEST(JudgeTest, SixFailedSolvesInARowLoseTheSolverFiveDoNot) {
  EXPECT_EQ(KindsOf(WithFailedSolves(5)), Kinds{});
  const RunOutcome lost = WithFailedSolves(6);
  EXPECT_EQ(KindsOf(lost), Kinds{"SOLVER"});
  EXPECT_EQ(lost.verdict.reasons[0].time_s, 0.01);
  EXPECT_NE(lost.verdict.reasons[0].text.find("iteration_limit"), std::string::npos);
  EXPECT_EQ(NumberOf(lost, "mpc_failures"), 6.0);
  EXPECT_EQ(NumberOf(lost, "solver_fallbacks"), 6.0);
}

TEST(JudgeTest, ASolveInBetweenForgivesTheRowBefore) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 300, [](Tick tick, WorldTruth&, ControlTick& control) {
        if (tick >= 22 || tick == 10) return;  // two rows of five control ticks
        control.mpc.status = SolveStatus::kInfeasible;
      });
  EXPECT_EQ(KindsOf(outcome), Kinds{"SOLVER"}) << "10 of 151 solves, though no row of six";
  const RunOutcome longer =
      OutcomeOf(OneFootScenario(), 600, [](Tick tick, WorldTruth&, ControlTick& control) {
        if (tick >= 22 || tick == 10) return;
        control.mpc.status = SolveStatus::kInfeasible;
      });
  EXPECT_EQ(KindsOf(longer), Kinds{});
  EXPECT_EQ(NumberOf(longer, "mpc_failures"), 10.0);
}

// Fails the first `count` of `solves` whole-body solves.
RunOutcome WithFailedWholeBody(int count, int solves) {
  return OutcomeOf(OneFootScenario(), (solves - 1) * kControlPeriod,
                   [=](Tick tick, WorldTruth&, ControlTick& control) {
                     control.wbc.ok = tick / kControlPeriod >= count;
                   });
}

TEST(JudgeTest, AWholeBodyThatFailsInMoreThanAShareOfItsSolvesIsNoPass) {
  EXPECT_EQ(KindsOf(WithFailedWholeBody(10, 200)), Kinds{}) << "5 % are borne, in a row or not";
  const RunOutcome lost = WithFailedWholeBody(11, 200);
  EXPECT_EQ(KindsOf(lost), Kinds{"SOLVER"});
  EXPECT_EQ(lost.verdict.reasons[0].text, "11 of 200 whole-body solves failed; at most 5 % may");
  EXPECT_EQ(NumberOf(lost, "wbc_failures"), 11.0);
  EXPECT_EQ(NumberOf(lost, "max_solver_failure_ratio"), 0.055);
  EXPECT_EQ(KindsOf(WithFailedWholeBody(5, 10)), Kinds{}) << "five of a short run are borne too";
  EXPECT_EQ(KindsOf(WithFailedWholeBody(6, 10)), Kinds{"SOLVER"});
}

TEST(JudgeTest, ABaselinesStepsAreSolvesToo) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 100, [](Tick tick, WorldTruth&, ControlTick& control) {
        if (tick % 10 != 0) return;  // nothing to decide then
        control.step.status = tick < 60 ? QpStatus::kInfeasible : QpStatus::kSolved;
      });
  EXPECT_EQ(KindsOf(outcome), Kinds{"SOLVER"});
  EXPECT_EQ(outcome.verdict.reasons[0].text, "6 of 11 step solves failed; at most 5 % may");
  EXPECT_EQ(NumberOf(outcome, "step_failures"), 6.0);
}

TEST(JudgeTest, EveryMissedExpectationIsAReason) {
  Scenario scenario = OneFootScenario();
  scenario.expect = {
      {"max_path_error_m", {}, 0.1, {}}, {"energy_J", 1.0, {}, {}}, {"max_slip_m", {}, 0.1, {}}};
  const RunOutcome outcome =
      OutcomeOf(scenario, 50, [](Tick, WorldTruth& truth, ControlTick&) { truth.p_WC.y() = 0.25; });
  EXPECT_EQ(KindsOf(outcome), (Kinds{"EXPECTATION", "EXPECTATION"}));
  EXPECT_EQ(outcome.verdict.reasons[0].text, "max_path_error_m is 0.25, expected at most 0.1");
  EXPECT_EQ(outcome.verdict.reasons[1].text, "energy_J is 0, expected at least 1");
}

TEST(JudgeTest, InvalidRunIsNeverAFallNorAPass) {
  const Scenario scenario = OneFootScenario();
  for (const char* kind : {reason::kDiverged, reason::kInterrupted, reason::kError}) {
    Judge judge = JudgeOf(scenario);
    Watch(judge, scenario, 150, SinkAfterTick100);
    judge.Invalidate(kind, "because", 0.15);
    EXPECT_TRUE(judge.finished());
    EXPECT_EQ(judge.Conclude().verdict.verdict_class, VerdictClass::kInvalid);
    EXPECT_EQ(KindsOf(judge.Conclude()), Kinds{kind});
  }
}

TEST(JudgeTest, StateThatIsNotFiniteIsDivergence) {
  const Scenario scenario = OneFootScenario();
  Judge judge = JudgeOf(scenario);
  const Tick last = Watch(judge, scenario, 500, [](Tick tick, WorldTruth& truth, ControlTick&) {
    if (tick == 70) truth.p_WB.x() = std::numeric_limits<double>::quiet_NaN();
  });
  EXPECT_EQ(last, 70);
  EXPECT_EQ(KindsOf(judge.Conclude()), Kinds{"DIVERGED"});
  EXPECT_EQ(judge.Conclude().verdict.reasons[0].time_s, 0.07);
}

TEST(JudgeTest, AddsUpImpulseAndEnergyAsTheyActed) {
  Scenario scenario = OneFootScenario();
  scenario.pushes.resize(1);
  scenario.pushes[0].start_s = 0.1;
  scenario.pushes[0].duration_s = 0.05;
  const RunOutcome outcome =
      OutcomeOf(scenario, 300, [](Tick tick, WorldTruth& truth, ControlTick&) {
        if (tick >= 100 && tick < 150) truth.pushes[0].force_W_N = {0.0, 20.0, 0.0};
        truth.actuator_power_W = 3.0;
      });
  EXPECT_LT((outcome.pushes.at(0).impulse_W_Ns - Eigen::Vector3d(0.0, 1.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "energy_J"), 3.0 * 0.3, 1e-12);
}

TEST(JudgeTest, AngularMomentumIsTheLargestOfTheRunAsALength) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 300, [](Tick tick, WorldTruth& truth, ControlTick&) {
        truth.angular_momentum =
            tick == 100 ? Eigen::Vector3d(0.3, -0.4, 0.0) : Eigen::Vector3d(0.0, 0.0, 0.45);
      });
  EXPECT_NEAR(NumberOf(outcome, "max_angular_momentum_kgm2ps"), 0.5, 1e-12);
}

TEST(JudgeTest, SpeedAlongXIsAdvanceOverTime) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 400, [](Tick tick, WorldTruth& truth, ControlTick&) {
        truth.p_WC.x() = 2.0 + 0.3 * 0.001 * static_cast<double>(tick);
      });
  EXPECT_NEAR(NumberOf(outcome, "mean_forward_speed_mps"), 0.3, 1e-12);
}

TEST(JudgeTest, TicksMustAscend) {
  const Scenario scenario = OneFootScenario();
  Judge judge = JudgeOf(scenario);
  judge.Add(3, StandingTruth(scenario), nullptr);
  EXPECT_THROW(judge.Add(3, StandingTruth(scenario), nullptr), ContractViolation);
}

}  // namespace
}  // namespace sidestep::judge_test
