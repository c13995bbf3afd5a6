// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/schedule_edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::schedule_edits_test {
namespace {

constexpr Tick kHorizon = 6000;

GaitSetup Then(GaitType type) {
  return SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(type, 1.0)},
                 type == GaitType::kHop ? 1 : 2);
}

GaitSetup Everything() {
  return SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 0.5),
                  Stretch(GaitType::kRun, 2.0), Stretch(GaitType::kStand, 4.0)},
                 2);
}

ContactSchedule Schedule(const GaitSetup& setup, const GaitSupport& support, Tick now) {
  ContactSchedule schedule;
  GenerateSchedule(setup, support, now, kHorizon, &schedule);
  return schedule;
}

ContactSchedule Stopped(const GaitSetup& setup, Tick now) {
  return Schedule(setup, StopNow(setup, SupportAt(setup, now), now), now);
}

int LandingsAfter(const ContactSchedule& schedule, Tick now) {
  int landings = 0;
  for (const auto& contacts : schedule.feet) {
    for (const NominalContact& nominal : contacts) landings += nominal.contact.start_tick > now;
  }
  return landings;
}

void ExpectStandsSideBySide(const ContactSchedule& schedule, double x_m) {
  for (const auto& contacts : schedule.feet) {
    EXPECT_FALSE(contacts.back().contact.end_is_known);
    EXPECT_NEAR(contacts.back().contact.nominal_p_WF.x(), x_m, 1e-12);
  }
  EXPECT_TRUE(schedule.com.back().at_rest);
  EXPECT_NEAR(schedule.com.back().p_WC.x(), x_m, 1e-12);
}

/// Expects that what has happened by `now` is the same in `edited` as in `original`.
void ExpectSamePast(const ContactSchedule& original, const ContactSchedule& edited, Tick now) {
  for (std::size_t foot = 0; foot < original.feet.size(); ++foot) {
    const NominalContact* before = ContactAt(original, foot, now);
    const NominalContact* after = ContactAt(edited, foot, now);
    ASSERT_EQ(before == nullptr, after == nullptr) << "foot " << foot << " at " << now;
    if (before == nullptr) continue;
    EXPECT_EQ(after->sequence, before->sequence) << now;
    EXPECT_EQ(after->contact.start_tick, before->contact.start_tick) << now;
  }
  for (std::size_t i = 1; i < edited.com.size(); ++i) {
    EXPECT_GE(edited.com[i].tick, edited.com[i - 1].tick) << now;
  }
  ASSERT_LE(edited.com.front().tick, now);
  const auto next = std::find_if(original.com.begin(), original.com.end(),
                                 [now](const ComKnot& knot) { return knot.tick > now; });
  const ComKnot& passed = *std::prev(next);
  EXPECT_TRUE(std::any_of(
      edited.com.begin(), edited.com.end(),
      [&](const ComKnot& knot) { return knot.tick == passed.tick && knot.p_WC == passed.p_WC; }))
      << "the knot at " << passed.tick << " was passed by " << now;
}

TEST(StopNowTest, StandingGoesOnStandingThoughTheSegmentsWouldWalk) {
  const ContactSchedule schedule = Stopped(Then(GaitType::kWalk), 500);
  EXPECT_EQ(LandingsAfter(schedule, 500), 0);
  ExpectStandsSideBySide(schedule, 0.0);
}

TEST(StopNowTest, BeforeTheFirstFootLeavesNoStepIsNeeded) {
  const GaitSetup setup = Then(GaitType::kWalk);  // lifts off at 1.2 s
  EXPECT_EQ(LandingsAfter(Stopped(setup, 1199), 1199), 0);
  ExpectStandsSideBySide(Stopped(setup, 1199), 0.0);
  EXPECT_EQ(LandingsAfter(Stopped(setup, 1200), 1200), 1) << "it has to come down";
  ExpectStandsSideBySide(Stopped(setup, 1200), 0.0);
}

TEST(StopNowTest, WalkingFootLandsBesideTheOtherWhenItWouldHaveLanded) {
  const GaitSetup setup = Then(GaitType::kWalk);
  // The left foot landed at 1.8 s at 0.1 m; the right one leaves at 2.0 s and lands at 2.6 s.
  for (const Tick now : {1800, 1999, 2000, 2599}) {
    const ContactSchedule schedule = Stopped(setup, now);
    EXPECT_EQ(LandingsAfter(schedule, now), 1) << now;
    EXPECT_EQ(schedule.feet[1].back().contact.start_tick, 2600) << now;
    ExpectStandsSideBySide(schedule, 0.1);
  }
}

TEST(StopNowTest, RunOnOneFootClosesByOneStepAndInFlightByTwo) {
  const GaitSetup setup = Then(GaitType::kRun);
  // The left foot lands at 1.4 s and leaves at 1.65 s; the right one is in the air till 1.8 s.
  const ContactSchedule on_a_foot = Stopped(setup, 1649);
  EXPECT_EQ(LandingsAfter(on_a_foot, 1649), 1);
  EXPECT_EQ(on_a_foot.feet[1].back().contact.start_tick, 1400 + 600) << "the gait's swing_s";
  ExpectStandsSideBySide(on_a_foot, 0.1);
  const ContactSchedule in_flight = Stopped(setup, 1650);
  EXPECT_EQ(LandingsAfter(in_flight, 1650), 2);
  EXPECT_EQ(in_flight.feet[1].back().contact.start_tick, 1800);
  ExpectStandsSideBySide(in_flight, 0.2);
}

TEST(StopNowTest, HopperOnTheGroundStaysAndInTheAirLandsWhereItWould) {
  const GaitSetup setup = Then(GaitType::kHop);  // in the air from 1.25 s to 1.4 s
  EXPECT_EQ(LandingsAfter(Stopped(setup, 1249), 1249), 0);
  ExpectStandsSideBySide(Stopped(setup, 1250), 0.1);
}

TEST(StopNowTest, AtAnyTickItEndsSideBySideByTwoStepsAtMostAndLeavesThePastAsItWas) {
  const GaitSetup setup = Everything();
  int steps = 0;
  for (Tick now = 0; now < 5500; now += 7) {
    const GaitSupport support = SupportAt(setup, now);
    const ContactSchedule schedule = Stopped(setup, now);
    ExpectSamePast(Schedule(setup, support, now), schedule, now);
    ExpectStandsSideBySide(schedule, schedule.feet[0].back().contact.nominal_p_WF.x());
    EXPECT_LE(LandingsAfter(schedule, now), 2) << now;
    steps += LandingsAfter(schedule, now);
    if (HasFailure()) break;
  }
  EXPECT_GT(steps, 100) << "it hardly ever walked";
}

TEST(StartNowTest, GaitBeginsNowWithTheGivenFootInThePlaceOfTheSegments) {
  const GaitSetup setup = Then(GaitType::kRun);
  const auto started =
      StartNow(setup, SupportAt(setup, 300), 300, Stretch(GaitType::kWalk, 0.0), 1);
  ASSERT_TRUE(started.has_value());
  const ContactSchedule schedule = Schedule(setup, *started, 300);
  ExpectSamePast(Schedule(setup, SupportAt(setup, 300), 300), schedule, 300);
  EXPECT_EQ(schedule.feet[1][0].contact.end_tick, 300 + 200);
  EXPECT_EQ(schedule.feet[1][1].contact.start_tick, 500 + 600);
  EXPECT_NEAR(schedule.feet[1][1].contact.nominal_p_WF.x(), 0.1, 1e-12);
  EXPECT_EQ(schedule.feet[0][1].contact.start_tick, 1100 + 800) << "no run at 1 s";
}

TEST(StartNowTest, IsWhatTheSegmentsWouldHaveDoneAtThatTime) {
  const GaitSetup stand = SetupOf({Stretch(GaitType::kStand, 0.0)}, 2);
  for (const GaitType type : {GaitType::kWalk, GaitType::kRun}) {
    const GaitSetup by_segments = Then(type);
    const auto started = StartNow(stand, SupportAt(stand, 1000), 1000, Stretch(type, 0.0), 0);
    ASSERT_TRUE(started.has_value());
    const ContactSchedule made = Schedule(stand, *started, 1000);
    const ContactSchedule meant = Schedule(by_segments, SupportAt(by_segments, 1000), 1000);
    ASSERT_EQ(made.com.size(), meant.com.size());
    for (std::size_t i = 0; i < made.com.size(); ++i) {
      EXPECT_EQ(made.com[i].tick, meant.com[i].tick);
      EXPECT_EQ(made.com[i].p_WC, meant.com[i].p_WC);
    }
    for (std::size_t foot = 0; foot < 2; ++foot) {
      ASSERT_EQ(made.feet[foot].size(), meant.feet[foot].size());
      EXPECT_EQ(made.feet[foot].back().contact.start_tick,
                meant.feet[foot].back().contact.start_tick);
    }
  }
}

TEST(StartNowTest, IsRefusedUnlessItStandsAndTheGaitFits) {
  const GaitSetup setup = Then(GaitType::kWalk);
  const GaitParams walk = Stretch(GaitType::kWalk, 0.0);
  const auto start = [&](Tick now, const GaitParams& gait, int foot) {
    return StartNow(setup, SupportAt(setup, now), now, gait, foot).has_value();
  };
  EXPECT_TRUE(start(999, walk, 0));
  EXPECT_FALSE(start(1000, walk, 0)) << "it walks";
  EXPECT_FALSE(start(500, walk, 2)) << "no such foot";
  EXPECT_FALSE(start(500, walk, -1));
  EXPECT_FALSE(start(500, Stretch(GaitType::kStand, 0.0), 0));
  EXPECT_FALSE(start(500, Stretch(GaitType::kHop, 0.0), 0)) << "for one foot";
  GaitParams hasty = Stretch(GaitType::kRun, 0.0);
  hasty.stance_s = hasty.flight_s = 0.005;
  EXPECT_FALSE(start(500, hasty, 0)) << "10 ms a step";
  const GaitSetup closing = Everything();
  const Tick apart = 4100;
  ASSERT_FALSE(SupportAt(closing, apart).feet[0].stands() &&
               SupportAt(closing, apart).feet[1].stands());
  EXPECT_FALSE(StartNow(closing, SupportAt(closing, apart), apart, walk, 0).has_value());
}

TEST(StepOnTheSpotTest, StandingRobotMakesTheStepsAndStandsAgain) {
  const GaitSetup setup = SetupOf({Stretch(GaitType::kStand, 0.0)}, 2);
  const auto stepping = StepOnTheSpot(setup, SupportAt(setup, 700), 700, {3, 0.4, 0.1, 1});
  ASSERT_TRUE(stepping.has_value());
  const ContactSchedule schedule = Schedule(setup, *stepping, 700);
  EXPECT_EQ(LandingsAfter(schedule, 700), 3);
  // 0.1 s of double support and 0.4 s of swing a step, the right foot first.
  EXPECT_EQ(schedule.feet[1][0].contact.end_tick, 800);
  EXPECT_EQ(schedule.feet[1][1].contact.start_tick, 1200);
  EXPECT_EQ(schedule.feet[0][0].contact.end_tick, 1300);
  EXPECT_EQ(schedule.feet[0][1].contact.start_tick, 1700);
  EXPECT_EQ(schedule.feet[1][2].contact.start_tick, 2200);
  ExpectStandsSideBySide(schedule, 0.0);
}

TEST(StepOnTheSpotTest, WalkGoesOnAfterwards) {
  const GaitSetup setup = Then(GaitType::kWalk);
  const auto stepping = StepOnTheSpot(setup, SupportAt(setup, 1900), 1900, {2, 0.3, 0.1, 1});
  ASSERT_TRUE(stepping.has_value());
  const ContactSchedule schedule = Schedule(setup, *stepping, 1900);
  // The right foot to the left one's 0.1 m, that one on its place, then a step of 0.1 m again.
  EXPECT_EQ(schedule.feet[1][1].contact.start_tick, 2300);
  EXPECT_NEAR(schedule.feet[1][1].contact.nominal_p_WF.x(), 0.1, 1e-12);
  EXPECT_EQ(schedule.feet[0][1].contact.start_tick, 2700);
  EXPECT_NEAR(schedule.feet[0][1].contact.nominal_p_WF.x(), 0.1, 1e-12);
  EXPECT_EQ(schedule.feet[1][2].contact.start_tick, 2700 + 800);
  EXPECT_NEAR(schedule.feet[1][2].contact.nominal_p_WF.x(), 0.2, 1e-12);
}

TEST(StepOnTheSpotTest, FootInTheAirLandsFirst) {
  const GaitSetup setup = Then(GaitType::kWalk);
  for (const int first : {0, 1}) {
    const auto stepping = StepOnTheSpot(setup, SupportAt(setup, 2300), 2300, {1, 0.3, 0.1, first});
    ASSERT_TRUE(stepping.has_value());
    const ContactSchedule schedule = Schedule(setup, *stepping, 2300);
    const auto& right = schedule.feet[1];
    EXPECT_EQ(right[0].contact.start_tick, 2600);
    EXPECT_NEAR(right[0].contact.nominal_p_WF.x(), 0.2, 1e-12) << "as planned";
    EXPECT_EQ(schedule.feet[static_cast<std::size_t>(first)][1].contact.start_tick, 2600 + 400);
  }
}

TEST(StepOnTheSpotTest, IsRefusedIfTheFootThatStandsAloneWouldHaveToLeave) {
  const GaitSetup setup = Then(GaitType::kRun);
  const GaitSupport support = SupportAt(setup, 1500);  // the right foot lands at 1.8 s
  EXPECT_FALSE(StepOnTheSpot(setup, support, 1500, {2, 0.3, 0.1, 1}).has_value());
  EXPECT_TRUE(StepOnTheSpot(setup, support, 1500, {2, 0.3, 0.1, 0}).has_value());
}

TEST(StepOnTheSpotTest, IsRefusedWithoutTwoFeetStepsOrTime) {
  const GaitSetup setup = Then(GaitType::kWalk), one = Then(GaitType::kHop);
  const GaitSupport support = StandingSupport(setup);
  EXPECT_FALSE(StepOnTheSpot(one, StandingSupport(one), 0, {1, 0.3, 0.1, 0}).has_value());
  EXPECT_FALSE(StepOnTheSpot(setup, support, 0, {0, 0.3, 0.1, 0}).has_value());
  EXPECT_FALSE(StepOnTheSpot(setup, support, 0, {1, 0.01, 0.1, 0}).has_value());
  EXPECT_FALSE(StepOnTheSpot(setup, support, 0, {1, 0.3, -0.1, 0}).has_value());
  EXPECT_FALSE(StepOnTheSpot(setup, support, 0, {1, 0.3, 0.1, 2}).has_value());
  EXPECT_TRUE(StepOnTheSpot(setup, support, 0, {1, 0.3, 0.1, 0}).has_value());
}

TEST(StepOnTheSpotTest, AtAnyTickThePastStaysAsItWas) {
  const GaitSetup setup = Everything();
  int stepped = 0;
  for (Tick now = 0; now < 5500; now += 7) {
    const GaitSupport support = SupportAt(setup, now);
    for (const int first : {0, 1}) {
      const auto stepping = StepOnTheSpot(setup, support, now, {2, 0.3, 0.1, first});
      if (!stepping) continue;
      ExpectSamePast(Schedule(setup, support, now), Schedule(setup, *stepping, now), now);
      ++stepped;
    }
    if (HasFailure()) break;
  }
  EXPECT_GT(stepped, 1000);
}

}  // namespace
}  // namespace sidestep::schedule_edits_test
