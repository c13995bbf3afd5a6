// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/step_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "models/support/require.h"
#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::step_log_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kMinLoad_N = 5.0;

using Motion = std::function<void(Tick, WorldTruth&)>;

/// Feet that stand, changed by `motion`, for ticks 0 to `end`.
StepLog LogOf(const Scenario& scenario, Tick end, const Motion& motion) {
  const NominalMotion nominal = NominalOf(scenario);
  const auto& feet = scenario.robot.feet;
  StepLog log(feet, kTick_s, scenario.world.ground);
  std::vector<StanceMeter> stances(feet.size(), StanceMeter(kTick_s, kMinLoad_N));
  for (Tick tick = 0; tick <= end; ++tick) {
    WorldTruth truth = StandingTruth(scenario);
    motion(tick, truth);
    for (std::size_t i = 0; i < feet.size(); ++i) stances[i].Add(tick, truth.feet[i]);
    log.Add(tick, truth, stances, std::vector<double>(feet.size(), 0.0), nominal);
  }
  return log;
}

void Lift(FootTruth& foot, double height_m) {
  foot.p_WF.z() = 0.02 + height_m;
  foot.in_contact = false;
  foot.f_F_W.setZero();
}

// The walk of TwoFeetScenario, `late` ticks behind, `aside_m` to the left of its path, each step
// longer by `longer_m`: touch-downs at 800, 1600, ... + late, the left foot's first, 0.6 s in the
// air and 4 cm high.
Motion Walk(Tick late, double aside_m, double longer_m) {
  return [=](Tick tick, WorldTruth& truth) {
    for (int foot = 0; foot < 2; ++foot) {
      FootTruth& one = truth.feet[static_cast<std::size_t>(foot)];
      const Tick first = late + 800 * (foot + 1);
      const Tick landed = tick < first ? 0 : (tick - first) / 1600 + 1;
      const Tick next = first + 1600 * landed;
      // Of all steps, the one that brought this foot here.
      const Tick step = landed == 0 ? 0 : 2 * landed - 1 + foot;
      one.p_WF.x() = (0.1 + longer_m) * static_cast<double>(step);
      one.p_WF.y() = (foot == 0 ? 0.08 : -0.08) + aside_m;
      if (tick >= next - 600) Lift(one, 0.04);
    }
  };
}

std::vector<double> AdjustmentsOf(const StepLog& log) { return log.AdjustmentsFrom(0); }

TEST(StepLogTest, WalkAsTheGaitWantsItIsAdjustedNowhere) {
  const StepLog log = LogOf(TwoFeetScenario(), 5000, Walk(0, 0.0, 0.0));
  ASSERT_EQ(log.touch_downs().size(), 2u + 6u) << "the stances of the start first";
  EXPECT_EQ(log.touch_downs()[2].tick, 800);
  EXPECT_EQ(log.touch_downs()[2].foot, 0u);
  EXPECT_NEAR(log.touch_downs()[7].p_WF.x(), 0.6, 1e-12);
  ASSERT_EQ(AdjustmentsOf(log).size(), 6u);
  for (const double adjustment_m : AdjustmentsOf(log)) EXPECT_NEAR(adjustment_m, 0.0, 1e-12);
  EXPECT_NEAR(log.min_swing_clearance_m(), 0.04, 1e-12);
}

TEST(StepLogTest, DriftAndDelayAreNoAdjustments) {
  // 0.3 m aside from the start, and more than a gait cycle late.
  const StepLog log = LogOf(TwoFeetScenario(), 9000, Walk(2000, 0.3, 0.0));
  ASSERT_EQ(AdjustmentsOf(log).size(), 8u);
  for (const double adjustment_m : AdjustmentsOf(log)) EXPECT_NEAR(adjustment_m, 0.0, 1e-12);
}

TEST(StepLogTest, EveryStepPaysForItselfAndNotForThoseBefore) {
  // Each step 2 cm too long: the sixth touch-down is 12 cm ahead and still adjusted by 2 cm.
  const StepLog log = LogOf(TwoFeetScenario(), 5000, Walk(0, 0.0, 0.02));
  ASSERT_EQ(AdjustmentsOf(log).size(), 6u);
  for (const double adjustment_m : AdjustmentsOf(log)) EXPECT_NEAR(adjustment_m, 0.02, 1e-12);
}

TEST(StepLogTest, OneStepAsideIsAdjustedOnceAndOnceMoreOnTheWayBack) {
  const Motion walk = Walk(0, 0.0, 0.0);
  const StepLog log = LogOf(TwoFeetScenario(), 5000, [&](Tick tick, WorldTruth& truth) {
    walk(tick, truth);
    if (tick >= 1800 && tick < 3400) truth.feet[0].p_WF.y() += 0.05;  // lands at 2400
  });
  const std::vector<double> adjustments_m = AdjustmentsOf(log);
  ASSERT_EQ(adjustments_m.size(), 6u);
  EXPECT_NEAR(adjustments_m[1], 0.0, 1e-12);
  EXPECT_NEAR(adjustments_m[2], 0.05, 1e-12) << "left foot goes out";
  EXPECT_NEAR(adjustments_m[3], 0.05, 1e-12) << "right foot stays on the path";
  EXPECT_NEAR(adjustments_m[4], 0.0, 1e-12);
}

// Stops walking at the touch-down of 5600: by then the left foot has made its last whole step, at
// 4000, and closes at 5600.
Scenario StoppingWalk() {
  Scenario scenario = TwoFeetScenario();
  scenario.gait.resize(2);
  scenario.gait[1].type = GaitType::kStand;
  scenario.gait[1].start_s = 4.8;
  return scenario;
}

TEST(StepLogTest, TheLastStepsOfALateRobotAreComparedWithTheGaitsLastSteps) {
  const Scenario scenario = StoppingWalk();
  const NominalMotion nominal = NominalOf(scenario);
  const Eigen::Vector3d closing = nominal.StepTo(0, nominal.contacts(0).size() - 1);
  ASSERT_GT((closing - nominal.StepTo(0, nominal.contacts(0).size() - 2)).norm(), 0.05)
      << "the gait's last step is another one than those before";
  // The gait's own steps, each foot set down where it wants it, but 1 s late: more than half a
  // stride.
  for (const Tick late : {0, 1000}) {
    const StepLog log = LogOf(scenario, 9000, [&](Tick tick, WorldTruth& truth) {
      for (std::size_t foot = 0; foot < 2; ++foot) {
        for (const PlannedContact& contact : nominal.contacts(foot)) {
          const Tick start = contact.start_tick + (contact.index == 0 ? 0 : late);
          if (tick >= start) truth.feet[foot].p_WF = contact.nominal_p_WF;
          if (tick < start && tick >= start - 600) Lift(truth.feet[foot], 0.04);
        }
      }
    });
    ASSERT_GE(AdjustmentsOf(log).size(), 6u);
    for (const double adjustment_m : AdjustmentsOf(log)) EXPECT_NEAR(adjustment_m, 0.0, 1e-12);
  }
}

TEST(StepLogTest, AFootThatBeginsInTheAirHasStepped) {
  // The right foot comes down at 500; the left one hops on before, with nowhere to step from.
  const StepLog log = LogOf(TwoFeetScenario(), 1000, [](Tick tick, WorldTruth& truth) {
    if (tick < 500) Lift(truth.feet[1], 0.04);
    if (tick >= 100 && tick < 250) Lift(truth.feet[0], 0.04);
  });
  ASSERT_EQ(log.touch_downs().size(), 3u);
  EXPECT_FALSE(log.touch_downs()[0].is_step) << "it stood there";
  EXPECT_TRUE(log.touch_downs()[1].is_step);
  EXPECT_FALSE(log.touch_downs()[1].adjustment_m) << "the other foot has not stood yet";
  EXPECT_TRUE(log.touch_downs()[2].is_step);
  EXPECT_TRUE(log.touch_downs()[2].adjustment_m);
  EXPECT_NEAR(log.min_swing_clearance_m(), 0.04, 1e-12);
}

TEST(StepLogTest, AStepGoesFromWhereTheOtherFootStoodLast) {
  // The right foot slides 3 cm forwards under load before the left one lands at 800.
  const Motion walk = Walk(0, 0.0, 0.0);
  const StepLog log = LogOf(TwoFeetScenario(), 900, [&](Tick tick, WorldTruth& truth) {
    walk(tick, truth);
    if (tick >= 500) truth.feet[1].p_WF.x() += 0.03;
  });
  ASSERT_EQ(AdjustmentsOf(log).size(), 1u);
  EXPECT_NEAR(AdjustmentsOf(log)[0], 0.03, 1e-12);
}

// A foot off the ground for `ticks`, `height_m` high, and set down `aside_m` further.
std::size_t StepsOf(Tick ticks, double height_m, double aside_m) {
  const StepLog log = LogOf(OneFootScenario(), 1000, [=](Tick tick, WorldTruth& truth) {
    if (tick >= 200) truth.feet[0].p_WF.y() = aside_m;
    if (tick >= 200 && tick < 200 + ticks) Lift(truth.feet[0], height_m);
  });
  return AdjustmentsOf(log).size();
}

TEST(StepLogTest, RockingAndBouncingAreNoSteps) {
  EXPECT_EQ(StepsOf(100, 0.006, 0.0), 1u);
  EXPECT_EQ(StepsOf(100, 0.004, 0.0), 0u) << "it rocks";
  EXPECT_EQ(StepsOf(100, 0.004, 0.02), 1u) << "low, but it goes somewhere";
  EXPECT_EQ(StepsOf(100, 0.004, 0.005), 0u);
  EXPECT_EQ(StepsOf(40, 0.006, 0.02), 0u) << "it bounces";
}

TEST(StepLogTest, AStepIsToldOnceItsStanceHasLasted50Milliseconds) {
  const Motion walk = Walk(0, 0.0, 0.0);
  EXPECT_EQ(LogOf(TwoFeetScenario(), 849, walk).touch_downs().size(), 2u);
  const StepLog log = LogOf(TwoFeetScenario(), 850, walk);
  ASSERT_EQ(log.touch_downs().size(), 3u);
  EXPECT_EQ(log.touch_downs()[2].tick, 800);
  EXPECT_EQ(log.touch_downs()[2].end_tick, 851);
}

TEST(StepLogTest, AFootThatScuffsTheGroundSwingsOn) {
  // The left foot's swing from 1800 to 2400 is at the same height on the ground from 2100 on, for
  // 10 or for 39 ms.
  const Motion walk = Walk(0, 0.0, 0.0);
  for (const Tick scuff : {10, 39}) {
    const StepLog log = LogOf(TwoFeetScenario(), 5000, [&](Tick tick, WorldTruth& truth) {
      walk(tick, truth);
      if (tick < 2100 || tick >= 2100 + scuff) return;
      truth.feet[0].in_contact = true;
      truth.feet[0].f_F_W.z() = 2.0 * kMinLoad_N;
      truth.feet[0].p_WF.x() -= 0.03;
    });
    ASSERT_EQ(log.touch_downs().size(), 2u + 6u);
    EXPECT_EQ(log.touch_downs()[4].tick, 2400);
    for (const double adjustment_m : AdjustmentsOf(log)) EXPECT_NEAR(adjustment_m, 0.0, 1e-12);
    EXPECT_NEAR(log.min_swing_clearance_m(), 0.04, 1e-12);
  }
}

TEST(StepLogTest, NobodyStepsFromWhereTheOtherFootScuffed) {
  // The right foot is in its swing when the left one lands at 2400, and scuffs from 2390 on.
  const Motion walk = Walk(0, 0.0, 0.0);
  const StepLog log = LogOf(TwoFeetScenario(), 2600, [&](Tick tick, WorldTruth& truth) {
    walk(tick, truth);
    if (tick >= 2100 && tick < 2600) Lift(truth.feet[1], 0.04);
    if (tick < 2390 || tick >= 2410) return;
    truth.feet[1].in_contact = true;
    truth.feet[1].f_F_W.z() = 2.0 * kMinLoad_N;
    truth.feet[1].p_WF.x() += 0.07;
  });
  ASSERT_EQ(AdjustmentsOf(log).size(), 3u);
  EXPECT_NEAR(AdjustmentsOf(log)[2], 0.0, 1e-12);
}

TEST(StepLogTest, LowSwingThatGoesSomewhereSetsTheClearance) {
  const StepLog log = LogOf(OneFootScenario(), 1000, [](Tick tick, WorldTruth& truth) {
    if (tick >= 200) truth.feet[0].p_WF.x() = 0.05;
    if (tick >= 200 && tick < 300) Lift(truth.feet[0], 0.002);
    if (tick >= 500 && tick < 600) Lift(truth.feet[0], 0.05);
  });
  EXPECT_NEAR(log.min_swing_clearance_m(), 0.002, 1e-12);
}

TEST(StepLogTest, ClearanceCountsFromTheGroundBelowTheFoot) {
  Scenario scenario = OneFootScenario();
  scenario.world.ground = {{0.5, 1.5, -1.0, 1.0, 0.03}};
  const StepLog log = LogOf(scenario, 1000, [](Tick tick, WorldTruth& truth) {
    if (tick >= 200) truth.feet[0].p_WF.x() = 1.0;
    truth.feet[0].p_WF.z() = tick >= 200 ? 0.05 : 0.02;
    if (tick >= 200 && tick < 300) Lift(truth.feet[0], 0.07);
  });
  EXPECT_NEAR(log.min_swing_clearance_m(), 0.04, 1e-12);
}

TEST(StepLogTest, TruthOfAnotherRobotBreaksTheContract) {
  const Scenario scenario = OneFootScenario();
  StepLog log(scenario.robot.feet, kTick_s);
  EXPECT_THROW(log.Add(0, StandingTruth(TwoFeetScenario()), {}, {}, NominalOf(scenario)),
               ContractViolation);
}

}  // namespace
}  // namespace sidestep::step_log_test
