// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/footstep_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::footstep_log_test {
namespace {

// Three contacts of a hopper, ticks [0, 100), [200, 300), [400, 500): the second is moved by
// 5 cm forwards, the third by 3 cm sideways. The MPC changes its mind while a foot flies.
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
  Scenario scenario = OneFootScenario();
  if (start_s) {
    scenario.pushes.resize(1);
    scenario.pushes[0].start_s = *start_s;
    scenario.pushes[0].duration_s = 0.01;
  }
  return OutcomeOf(scenario, 480, Hop);
}

TEST(FootstepLogTest, KeepsContactsAsPlannedWhenTheyBeganAndAsTheyLanded) {
  const RunOutcome outcome = HopWithPushAt({});
  ASSERT_EQ(outcome.footsteps.size(), 3u);
  const FootstepRecord& second = outcome.footsteps[1];
  EXPECT_EQ(second.contact.index, 1);
  EXPECT_EQ(second.contact.start_tick, 200);
  EXPECT_NEAR(second.contact.adjusted_p_WF.x(), 0.15, 1e-15) << "not what was planned in flight";
  ASSERT_TRUE(second.realised_p_WF.has_value());
  EXPECT_NEAR(second.realised_p_WF->x(), 0.14, 1e-15);
  EXPECT_EQ(second.slip_m, 0.0);
}

TEST(FootstepLogTest, ContactThatNeverLandsHasNoPlace) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 480, [](Tick tick, WorldTruth& truth, ControlTick& control) {
        Hop(tick, truth, control);
        if (tick >= 100) truth.feet[0].in_contact = false;
      });
  ASSERT_EQ(outcome.footsteps.size(), 3u);
  EXPECT_TRUE(outcome.footsteps[0].realised_p_WF.has_value());
  EXPECT_FALSE(outcome.footsteps[1].realised_p_WF.has_value());
}

TEST(FootstepLogTest, AdjustmentsCountFromTheFirstPushOn) {
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "mean_step_adjustment_m"), 0.04, 1e-12)
      << "the contact of the start is no step";
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "max_step_adjustment_m"), 0.05, 1e-12);
  EXPECT_NEAR(NumberOf(HopWithPushAt(0.25), "mean_step_adjustment_m"), 0.03, 1e-12);
  EXPECT_NEAR(NumberOf(HopWithPushAt(0.25), "max_step_adjustment_m"), 0.03, 1e-12);
  EXPECT_TRUE(std::isnan(NumberOf(HopWithPushAt(0.45), "mean_step_adjustment_m")));
  EXPECT_EQ(NumberOf(HopWithPushAt(0.45), "max_step_adjustment_m"), 0.0);
}

TEST(FootstepLogTest, BoxViolationIsMeasuredInTheContactsAxes) {
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "max_box_violation_m"), 0.01, 1e-12);
  PlannedContact contact = ContactAt(400);
  contact.R_WF = Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(BoxViolation_m(contact), 0.0, 1e-12) << "3 cm along y are now along the box's x";
  contact.adjusted_p_WF.z() -= 0.005;
  EXPECT_NEAR(BoxViolation_m(contact), 0.005, 1e-12);
}

TEST(FootstepLogTest, ClearanceIsTheLowestSwingsApexAboveTheSolesHeight) {
  // Sampled at 1 ms the apex of 40 mm is met within 4 um.
  EXPECT_NEAR(NumberOf(HopWithPushAt({}), "min_swing_clearance_m"), 0.04, 1e-5);
}

TEST(FootstepLogTest, RobotThatNeverSwingsHasNoClearance) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 100, [](Tick, WorldTruth&, ControlTick&) {});
  EXPECT_TRUE(std::isnan(NumberOf(outcome, "min_swing_clearance_m")));
}

TEST(FootstepLogTest, SlipBelongsToTheContactInWhichItHappened) {
  const RunOutcome outcome =
      OutcomeOf(OneFootScenario(), 480, [](Tick tick, WorldTruth& truth, ControlTick& control) {
        Hop(tick, truth, control);
        if (tick >= 250 && tick < 300) truth.feet[0].p_WF.y() += 0.004;
      });
  EXPECT_EQ(outcome.footsteps[0].slip_m, 0.0);
  EXPECT_NEAR(outcome.footsteps[1].slip_m, 0.004, 1e-12);
  EXPECT_EQ(outcome.footsteps[2].slip_m, 0.0);
}

}  // namespace
}  // namespace sidestep::footstep_log_test
