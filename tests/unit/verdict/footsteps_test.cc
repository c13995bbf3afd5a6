// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/footsteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/verdict/metrics.h"
#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::footsteps_test {
namespace {

using Pairs = std::vector<std::optional<std::size_t>>;
using Ticks = std::vector<Tick>;
constexpr auto kNone = std::nullopt;

TEST(PairByTimeTest, LateAndEarlyTouchDownsKeepTheirContacts) {
  EXPECT_EQ(PairByTime(Ticks{0, 200, 400}, Ticks{3, 290, 310}), (Pairs{0, 1, 2}));
  EXPECT_EQ(PairByTime(Ticks{0, 200, 400}, Ticks{0, 110, 301}), (Pairs{0, 1, 2}));
}

TEST(PairByTimeTest, AnExtraStepTakesNoOtherStepsContact) {
  EXPECT_EQ(PairByTime(Ticks{0, 200, 400}, Ticks{0, 150, 205, 400}), (Pairs{0, 2, 3}));
}

TEST(PairByTimeTest, AMissingStepLeavesItsContactAlone) {
  EXPECT_EQ(PairByTime(Ticks{0, 200, 400, 600}, Ticks{0, 405, 600}), (Pairs{0, kNone, 1, 2}));
  EXPECT_EQ(PairByTime(Ticks{0, 200}, Ticks{}), (Pairs{kNone, kNone}));
  EXPECT_EQ(PairByTime(Ticks{}, Ticks{5}), Pairs{});
}

TEST(PairByTimeTest, OfTwoAsNearTheEarlierHasIt) {
  EXPECT_EQ(PairByTime(Ticks{0, 200}, Ticks{100}), (Pairs{0, kNone}));
  EXPECT_EQ(PairByTime(Ticks{200}, Ticks{190, 210}), Pairs{0});
}

// A hopper's three contacts, ticks [0, 100), [200, 300), [400, 500), 0.1 m apart.
Scenario HopScenario() {
  Scenario scenario = OneFootScenario();
  scenario.gait[0].type = GaitType::kHop;
  scenario.gait[0].stance_s = scenario.gait[0].flight_s = 0.1;
  scenario.gait[0].step_length_m = 0.1;
  scenario.gait[0].step_width_m = 0.0;
  scenario.control.mpc.box_lower_m = {-0.1, -0.02, 0.0};
  scenario.control.mpc.box_upper_m = {0.1, 0.02, 0.0};
  return scenario;
}

// As its controller plans them: the second is moved by 5 cm forwards, the third by 3 cm sideways.
// The MPC changes its mind while a foot flies.
PlannedContact ContactAt(Tick tick) {
  PlannedContact contact;
  contact.index = tick < 100 ? 0 : tick < 300 ? 1 : 2;
  contact.start_tick = 200 * contact.index;
  contact.end_tick = contact.start_tick + 100;
  contact.nominal_p_WF = {0.1 * contact.index, 0.0, 0.02};
  contact.adjusted_p_WF = contact.nominal_p_WF;
  if (contact.index == 1) contact.adjusted_p_WF.x() += tick < 200 ? 0.01 : 0.05;
  if (contact.index == 2) contact.adjusted_p_WF.y() += 0.03;
  contact.box_lower_m = {-0.1, -0.02, 0.0};
  contact.box_upper_m = {0.1, 0.02, 0.0};
  return contact;
}

void Hop(Tick tick, WorldTruth& truth, ControlTick& control) {
  FootTarget& target = control.feet[0];
  target.contact = ContactAt(tick);
  target.planned_contact = tick >= target.contact.start_tick && tick < target.contact.end_tick;
  FootTruth& foot = truth.feet[0];
  // Lands 7 ms late, 1 cm short of where it should; the second swing is higher than the first.
  foot.in_contact = tick < 100 || (tick >= 207 && tick < 300) || tick >= 407;
  const double apex_m = tick < 250 ? 0.04 : 0.06;
  foot.p_WF = target.contact.adjusted_p_WF - Eigen::Vector3d(0.01, 0.0, 0.0);
  foot.p_WF.z() = 0.02;
  if (!foot.in_contact) {
    foot.p_WF.z() +=
        apex_m * std::sin(std::numbers::pi * static_cast<double>(tick % 200 - 100) / 107.0);
    foot.f_F_W.setZero();
  }
}

RunOutcome HopWithPushAt(std::optional<double> start_s) {
  Scenario scenario = HopScenario();
  if (start_s) {
    scenario.pushes.resize(1);
    scenario.pushes[0].start_s = *start_s;
    scenario.pushes[0].duration_s = 0.01;
  }
  return OutcomeOf(scenario, 480, Hop);
}

TEST(FootstepsTest, TellTheGaitsContactWhatWasPlannedWhenItBeganAndWhereTheFootLanded) {
  const RunOutcome outcome = HopWithPushAt({});
  ASSERT_EQ(outcome.footsteps.size(), 3u);
  const FootstepRecord& second = outcome.footsteps[1];
  EXPECT_EQ(second.contact.index, 1);
  EXPECT_EQ(second.contact.start_tick, 200);
  EXPECT_EQ(second.contact.end_tick, 300);
  EXPECT_NEAR(second.contact.nominal_p_WF.x(), 0.1, 1e-15);
  EXPECT_NEAR(second.contact.adjusted_p_WF.x(), 0.15, 1e-15) << "not what was planned in flight";
  ASSERT_TRUE(second.realised_p_WF.has_value());
  EXPECT_NEAR(second.realised_p_WF->x(), 0.14, 1e-15);
  EXPECT_EQ(second.slip_m, 0.0);
}

TEST(FootstepsTest, ContactThatNeverLandsHasNoPlace) {
  const RunOutcome outcome =
      OutcomeOf(HopScenario(), 480, [](Tick tick, WorldTruth& truth, ControlTick& control) {
        Hop(tick, truth, control);
        if (tick >= 100) truth.feet[0].in_contact = false;
      });
  ASSERT_EQ(outcome.footsteps.size(), 3u);
  EXPECT_TRUE(outcome.footsteps[0].realised_p_WF.has_value());
  EXPECT_FALSE(outcome.footsteps[1].realised_p_WF.has_value());
}

TEST(FootstepsTest, ControllerThatTellsNothingLeavesTheNominalPlaceAndTheTruth) {
  const RunOutcome told = HopWithPushAt({});
  const Scenario scenario = HopScenario();
  Judge judge = JudgeOf(scenario);
  for (Tick tick = 0; tick <= 480; ++tick) {
    WorldTruth truth = StandingTruth(scenario);
    ControlTick control = StandingControl(scenario);
    Hop(tick, truth, control);
    judge.Add(tick, truth, nullptr);
  }
  const RunOutcome outcome = judge.Conclude();
  ASSERT_EQ(outcome.footsteps.size(), 3u);
  EXPECT_EQ(outcome.footsteps[1].contact.adjusted_p_WF, outcome.footsteps[1].contact.nominal_p_WF);
  EXPECT_FALSE(outcome.footsteps[1].is_planned);
  EXPECT_TRUE(told.footsteps[1].is_planned);
  EXPECT_EQ(outcome.footsteps[1].realised_p_WF, told.footsteps[1].realised_p_WF);
  for (const MetricInfo& info : KnownMetrics()) {
    if (info.group != MetricGroup::kTruth || info.is_bool) continue;
    const std::string name(info.name);
    const double here = NumberOf(outcome, name), there = NumberOf(told, name);
    EXPECT_TRUE(here == there || (std::isnan(here) && std::isnan(there))) << name;
  }
  EXPECT_TRUE(std::isnan(NumberOf(outcome, "planned_mean_step_adjustment_m")));
  EXPECT_NEAR(NumberOf(told, "planned_max_step_adjustment_m"), 0.05, 1e-15);
}

TEST(FootstepsTest, StepThatTheGaitDoesNotHaveIsTold) {
  // It stands; at 0.5 s it makes a hop of 0.1 m to the left.
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 800, [](Tick tick, WorldTruth& truth, ControlTick&) {
        truth.feet[0].in_contact = tick < 500 || tick >= 600;
        if (tick < 500) return;
        truth.feet[0].p_WF.y() = 0.1;
        if (tick < 600) truth.feet[0].p_WF.z() = 0.06;
      });
  ASSERT_EQ(outcome.footsteps.size(), 2u);
  const FootstepRecord& extra = outcome.footsteps[1];
  EXPECT_EQ(extra.contact.index, -1);
  EXPECT_EQ(extra.contact.start_tick, 600);
  EXPECT_EQ(extra.contact.end_tick, 801) << "it stood to the end";
  EXPECT_EQ(extra.contact.nominal_p_WF.y(), 0.0);
  EXPECT_EQ(extra.realised_p_WF->y(), 0.1);
  EXPECT_EQ(NumberOf(outcome, "max_step_adjustment_m"), 0.1) << "the gait stands on the spot";
}

// It stands for a second in which its controller plans a contact that begins at tick 500, 3 cm
// aside; the foot hops at 0.4 s and comes down at `landing`.
FootstepRecord ExtraLandingAt(Tick landing) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 1000, [=](Tick tick, WorldTruth& truth, ControlTick& control) {
        truth.feet[0].in_contact = tick < 400 || tick >= landing;
        if (!truth.feet[0].in_contact) truth.feet[0].p_WF.z() = 0.06;
        PlannedContact& contact = control.feet[0].contact;
        if (tick < 500) return;
        contact.index = 1;
        contact.start_tick = 500;
        contact.adjusted_p_WF.y() = 0.03;
      });
  EXPECT_EQ(outcome.footsteps.size(), 2u);
  return outcome.footsteps.at(1);
}

TEST(FootstepsTest, AnExtraStepIsNotOfAPlanThatIsFarFromItInTime) {
  EXPECT_EQ(ExtraLandingAt(560).contact.index, -1);
  EXPECT_EQ(ExtraLandingAt(560).contact.adjusted_p_WF.y(), 0.03);
  EXPECT_EQ(ExtraLandingAt(800).contact.adjusted_p_WF.y(), 0.03) << "0.3 s";
  EXPECT_TRUE(ExtraLandingAt(800).is_planned);
  EXPECT_EQ(ExtraLandingAt(801).contact.adjusted_p_WF.y(), 0.0);
  EXPECT_FALSE(ExtraLandingAt(801).is_planned);
}

TEST(FootstepsTest, ScheduleThatIsLateByMoreThanHalfAStrideGoesOnWithTheNextContact) {
  // The hops of HopScenario, 120 ticks late: at 320 and 520. The contacts begin at 200 and 400.
  Scenario scenario = HopScenario();
  scenario.gait.resize(2);
  scenario.gait[1].start_s = 0.3;  // it stands from the landing at 400 on
  const RunOutcome outcome =
      OutcomeOf(scenario, 700, [](Tick tick, WorldTruth& truth, ControlTick&) {
        FootTruth& foot = truth.feet[0];
        foot.in_contact = tick < 220 || (tick >= 320 && tick < 420) || tick >= 520;
        foot.p_WF.x() = tick < 320 ? 0.0 : tick < 520 ? 0.1 : 0.2;
        if (!foot.in_contact) foot.p_WF.z() = 0.06;
      });
  ASSERT_EQ(outcome.footsteps.size(), 4u);
  EXPECT_FALSE(outcome.footsteps[1].realised_p_WF) << "the first that it skipped";
  EXPECT_NEAR(outcome.footsteps[2].realised_p_WF->x(), 0.1, 1e-12) << "beside the one at 400";
  EXPECT_EQ(outcome.footsteps[3].contact.index, -1) << "none is left";
  EXPECT_NEAR(NumberOf(outcome, "max_step_adjustment_m"), 0.0, 1e-12);
}

TEST(FootstepsTest, BoxStaysThePlannersThoughItsNominalPlaceWasAnother) {
  // The planner has shifted its path by 0.4 m to the side.
  const RunOutcome outcome =
      OutcomeOf(HopScenario(), 480, [](Tick tick, WorldTruth& truth, ControlTick& control) {
        Hop(tick, truth, control);
        control.feet[0].contact.nominal_p_WF.y() += 0.4;
        control.feet[0].contact.adjusted_p_WF.y() += 0.4;
      });
  const PlannedContact& second = outcome.footsteps[1].contact;
  EXPECT_NEAR(second.nominal_p_WF.y(), 0.0, 1e-15);
  EXPECT_NEAR(second.adjusted_p_WF.y(), 0.4, 1e-15);
  EXPECT_NEAR(second.box_lower_m.y(), 0.38, 1e-12);
  EXPECT_NEAR(second.box_upper_m.y(), 0.42, 1e-12);
}

TEST(FootstepsTest, SlipBelongsToTheContactInWhichItHappened) {
  const RunOutcome outcome =
      OutcomeOf(HopScenario(), 480, [](Tick tick, WorldTruth& truth, ControlTick& control) {
        Hop(tick, truth, control);
        if (tick >= 250 && tick < 300) truth.feet[0].p_WF.y() += 0.004;
      });
  EXPECT_EQ(outcome.footsteps[0].slip_m, 0.0);
  EXPECT_NEAR(outcome.footsteps[1].slip_m, 0.004, 1e-12);
  EXPECT_EQ(outcome.footsteps[2].slip_m, 0.0);
}

TEST(PlanLogTest, PlannedAdjustmentsCountFromTheFirstPushOn) {
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "planned_mean_step_adjustment_m"), 0.04, 1e-12)
      << "the contact of the start is no step";
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "planned_max_step_adjustment_m"), 0.05, 1e-12);
  EXPECT_NEAR(NumberOf(HopWithPushAt(0.25), "planned_mean_step_adjustment_m"), 0.03, 1e-12);
  EXPECT_NEAR(NumberOf(HopWithPushAt(0.25), "planned_max_step_adjustment_m"), 0.03, 1e-12);
  EXPECT_TRUE(std::isnan(NumberOf(HopWithPushAt(0.45), "planned_mean_step_adjustment_m")));
  EXPECT_EQ(NumberOf(HopWithPushAt(0.45), "planned_max_step_adjustment_m"), 0.0);
}

TEST(StepLogTest, TrueAdjustmentsCountFromTheFirstPushOn) {
  // By hand: the steps are (0.15, 0) and (0.05, 0.03), the gait's (0.1, 0).
  const double first_m = 0.05, second_m = std::hypot(0.05, 0.03);
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "mean_step_adjustment_m"), 0.5 * (first_m + second_m),
              1e-12);
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "max_step_adjustment_m"), second_m, 1e-12);
  EXPECT_NEAR(NumberOf(HopWithPushAt(0.25), "mean_step_adjustment_m"), second_m, 1e-12);
  EXPECT_TRUE(std::isnan(NumberOf(HopWithPushAt(0.45), "mean_step_adjustment_m")));
  EXPECT_EQ(NumberOf(HopWithPushAt(0.45), "max_step_adjustment_m"), 0.0);
}

TEST(PlanLogTest, BoxViolationIsMeasuredInTheContactsAxes) {
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "max_box_violation_m"), 0.01, 1e-12);
  PlannedContact contact = ContactAt(400);
  contact.R_WF = Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(BoxViolation_m(contact), 0.0, 1e-12) << "3 cm along y are now along the box's x";
  contact.adjusted_p_WF.x() += 0.025;
  EXPECT_NEAR(BoxViolation_m(contact), 0.005, 1e-12);
  contact.adjusted_p_WF.z() -= 0.5;
  EXPECT_NEAR(BoxViolation_m(contact), 0.005, 1e-12) << "heights are the ground's";
}

TEST(PlanLogTest, WhereAFootWasFeltToLandViolatesNoBox) {
  const RunOutcome outcome =
      OutcomeOf(HopScenario(), 480, [](Tick tick, WorldTruth& truth, ControlTick& control) {
        Hop(tick, truth, control);
        if (control.feet[0].planned_contact) control.feet[0].contact.adjusted_p_WF.y() += 0.4;
      });
  EXPECT_NEAR(NumberOf(outcome, "max_box_violation_m"), 0.01, 1e-12);
}

TEST(StepLogTest, ClearanceIsTheLowestSwingsApexAboveTheSolesHeight) {
  // Sampled at 1 ms the apex of 40 mm is met within 4 um.
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "min_swing_clearance_m"), 0.04, 1e-5);
}

TEST(StepLogTest, RobotThatNeverSwingsHasNoClearance) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 100, [](Tick, WorldTruth&, ControlTick&) {});
  EXPECT_TRUE(std::isnan(NumberOf(outcome, "min_swing_clearance_m")));
}

}  // namespace
}  // namespace sidestep::footsteps_test
