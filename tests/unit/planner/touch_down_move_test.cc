// SPDX-License-Identifier: BSD-3-Clause
// MoveTouchDown: one touch-down earlier or later, and all that follows with it.
#include <gtest/gtest.h>

#include <algorithm>

#include "controller/planner/schedule_edits.h"
#include "models/support/require.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::touch_down_move_test {
namespace {

constexpr Tick kHorizon = 4000;
constexpr Tick kLeast = 300;
// Walking from 1 s on: the left foot is in the air from 1.2 s to 1.8 s (landing 1), the right one
// from 2.0 s to 2.6 s (landing 2), the left one again from 2.8 s to 3.4 s (landing 3).
constexpr Tick kLeftSwings = 1500;

GaitSetup Walking() {
  return SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 1.0)}, 2);
}

ContactSchedule Schedule(const GaitSetup& setup, const GaitSupport& support, Tick now) {
  ContactSchedule schedule;
  GenerateSchedule(setup, support, now, kHorizon, &schedule);
  return schedule;
}

std::optional<GaitSupport> Move(const GaitSetup& setup, Tick now, int sequence, Tick by,
                                Tick least_swing = kLeast) {
  return MoveTouchDown(setup, SupportAt(setup, now), now, {sequence, by}, least_swing);
}

/// Expects of `edited` that what is at `touch_down` or later in `original` is `by` later.
void ExpectMoved(const ContactSchedule& original, const ContactSchedule& edited, Tick touch_down,
                 Tick by) {
  const auto moved = [&](Tick tick) { return tick >= touch_down ? tick + by : tick; };
  int compared = 0;
  for (std::size_t foot = 0; foot < original.feet.size(); ++foot) {
    const std::size_t both = std::min(original.feet[foot].size(), edited.feet[foot].size());
    for (std::size_t i = 0; i < both; ++i, ++compared) {
      const NominalContact& before = original.feet[foot][i];
      const NominalContact& after = edited.feet[foot][i];
      EXPECT_EQ(after.sequence, before.sequence);
      EXPECT_EQ(after.contact.start_tick, moved(before.contact.start_tick));
      EXPECT_EQ(after.contact.end_tick, moved(before.contact.end_tick));
      EXPECT_EQ(after.contact.nominal_p_WF, before.contact.nominal_p_WF);
    }
  }
  EXPECT_GT(compared, 5);
  for (std::size_t i = 0; i < std::min(original.com.size(), edited.com.size()); ++i) {
    EXPECT_EQ(edited.com[i].tick, moved(original.com[i].tick));
    EXPECT_EQ(edited.com[i].p_WC, original.com[i].p_WC);
  }
}

TEST(TouchDownMoveTest, LaterOrEarlierEverythingAfterItMovesAlong) {
  const GaitSetup setup = Walking();
  const GaitSupport support = SupportAt(setup, kLeftSwings);
  const ContactSchedule original = Schedule(setup, support, kLeftSwings);
  for (const Tick by : {100, 1, -1, -200}) {
    for (const int landing : {1, 2, 3}) {
      const auto edited = Move(setup, kLeftSwings, landing, by);
      ASSERT_TRUE(edited.has_value()) << landing << " by " << by;
      ExpectMoved(original, Schedule(setup, *edited, kLeftSwings), 1000 + 800 * landing, by);
    }
  }
}

TEST(TouchDownMoveTest, HopLandsLaterAndItsNextLiftOffToo) {
  const GaitSetup setup = SetupOf({Stretch(GaitType::kHop, 0.0)}, 1);
  const auto edited = Move(setup, 300, 1, 50, 100);  // in the air from 250 to 400
  ASSERT_TRUE(edited.has_value());
  const auto contacts = Schedule(setup, *edited, 300).feet[0];
  EXPECT_EQ(contacts[0].contact.start_tick, 450);
  EXPECT_EQ(contacts[0].contact.end_tick, 700);
  EXPECT_EQ(contacts[1].contact.start_tick, 850);
}

TEST(TouchDownMoveTest, MoveIsForgottenOnceItHasLanded) {
  const GaitSetup setup = Walking();
  const auto edited = Move(setup, kLeftSwings, 1, 100);
  const auto landed = NextSupport(setup, *edited);
  EXPECT_EQ(landed->tick, 1900);
  EXPECT_EQ(NextSupport(setup, *landed)->tick, 2700) << "800 ticks a step again";
}

TEST(TouchDownMoveTest, MovesOfOneLandingAddUp) {
  const GaitSetup setup = Walking();
  auto edited = Move(setup, kLeftSwings, 2, 60);
  edited = MoveTouchDown(setup, *edited, kLeftSwings, {2, 40}, kLeast);
  const ContactSchedule original = Schedule(setup, SupportAt(setup, kLeftSwings), kLeftSwings);
  ExpectMoved(original, Schedule(setup, *edited, kLeftSwings), 2600, 100);
  edited = MoveTouchDown(setup, *edited, kLeftSwings, {2, -100}, kLeast);
  ExpectMoved(original, Schedule(setup, *edited, kLeftSwings), 2600, 0);
}

TEST(TouchDownMoveTest, SwingShorterThanTheLeastIsRefused) {
  const GaitSetup setup = Walking();
  EXPECT_TRUE(Move(setup, 1250, 1, -300).has_value()) << "300 ticks in the air";
  EXPECT_FALSE(Move(setup, 1250, 1, -301).has_value());
  EXPECT_TRUE(Move(setup, 1250, 3, -300).has_value());
  EXPECT_FALSE(Move(setup, 1250, 3, -301).has_value());
}

TEST(TouchDownMoveTest, TouchDownThatWouldBeOverIsRefused) {
  const GaitSetup setup = Walking();
  EXPECT_TRUE(Move(setup, kLeftSwings, 1, -299, 0).has_value()) << "at 1501";
  EXPECT_FALSE(Move(setup, kLeftSwings, 1, -300, 0).has_value()) << "now";
}

TEST(TouchDownMoveTest, RunningFootThatWouldLandBeforeTheOtherHasLeftIsRefused) {
  const GaitSetup setup =
      SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kRun, 1.0)}, 2);
  EXPECT_TRUE(Move(setup, 1100, 2, -150, 0).has_value()) << "a flight of 150 ticks is left out";
  EXPECT_FALSE(Move(setup, 1100, 2, -151, 0).has_value());
}

TEST(TouchDownMoveTest, LandingByTheOneBeforeItIsRefusedHoweverFarItIsAsked) {
  const GaitSetup setup =
      SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kRun, 1.0)}, 2);
  for (const Tick by : {-400, -401, -100000}) {
    EXPECT_FALSE(Move(setup, 1100, 2, by, 0).has_value()) << by;
  }
}

TEST(TouchDownMoveTest, LandingThatIsNotToComeIsRefused) {
  const GaitSetup setup = Walking();
  EXPECT_FALSE(Move(setup, 2000, 1, 10).has_value()) << "it has landed";
  EXPECT_FALSE(Move(setup, 2000, 0, 10).has_value());
  EXPECT_TRUE(Move(setup, 2000, 17, 10).has_value());
  EXPECT_FALSE(Move(setup, 2000, 18, 10).has_value()) << "too far to tell";
  const GaitSetup closing =
      SetupOf({Stretch(GaitType::kWalk, 0.0), Stretch(GaitType::kStand, 1.0)}, 2);
  EXPECT_TRUE(Move(closing, 100, 3, 10).has_value()) << "the closing step";
  EXPECT_FALSE(Move(closing, 100, 4, 10).has_value()) << "it stands";
}

TEST(TouchDownMoveTest, FifthLandingIsRefused) {
  const GaitSetup setup = Walking();
  std::optional<GaitSupport> edited = SupportAt(setup, 1000);
  for (int landing = 1; landing <= 4; ++landing) {
    edited = MoveTouchDown(setup, *edited, 1000, {landing, 10}, kLeast);
    ASSERT_TRUE(edited.has_value()) << landing;
  }
  EXPECT_FALSE(MoveTouchDown(setup, *edited, 1000, {5, 10}, kLeast).has_value());
  const auto landed = NextSupport(setup, *edited);
  EXPECT_TRUE(MoveTouchDown(setup, *landed, landed->tick, {5, 10}, kLeast).has_value())
      << "one of the four has landed";
}

TEST(TouchDownMoveTest, SwayStaysInTheMiddleOfTheSwing) {
  GaitSetup setup = Walking();
  setup.geometry.sway.share = 0.3;
  const auto edited = Move(setup, 1250, 1, 100);
  const ContactSchedule schedule = Schedule(setup, *edited, 1250);
  const auto is_of_the_swing = [](const ComKnot& knot) { return knot.tick == 1200 + 700 / 2; };
  EXPECT_EQ(std::count_if(schedule.com.begin(), schedule.com.end(), is_of_the_swing), 1);
}

TEST(TouchDownMoveTest, DelayOverASegmentsStartLetsThatOneBeginThere) {
  const GaitSetup setup =
      SetupOf({Stretch(GaitType::kWalk, 0.0), Stretch(GaitType::kRun, 1.65)}, 2);
  EXPECT_EQ(SupportAt(setup, 1640).tick, 1600) << "a walk's step begins before the run";
  const auto edited = Move(setup, 1000, 2, 50);
  const auto run = NextSupport(setup, *edited);
  EXPECT_EQ(run->tick, 1650);
  EXPECT_EQ(NextSupport(setup, *run)->tick, 1650 + 400) << "stance and flight";
}

TEST(TouchDownMoveTest, LaterMoveOfAStepThatHasBecomeAShorterOneStillLetsItLand) {
  GaitParams quick = Stretch(GaitType::kWalk, 2.65);
  quick.swing_s = 0.3;
  const GaitSetup setup = SetupOf({Stretch(GaitType::kWalk, 0.0), quick}, 2);
  // Landing 4 comes at 3.2 s, of a step that begins at 2.4 s, still with a swing of 0.6 s.
  auto edited = MoveTouchDown(setup, SupportAt(setup, 1000), 1000, {4, -400}, 200);
  ASSERT_TRUE(edited.has_value());
  edited = MoveTouchDown(setup, *edited, 1000, {2, 300}, kLeast);
  ASSERT_TRUE(edited.has_value());
  GaitSupport support = *edited;
  while (support.sequence < 3) support = *NextSupport(setup, support);
  EXPECT_EQ(support.tick, 2700) << "the quick gait is on";
  const GaitSupport landed = *NextSupport(setup, support);
  EXPECT_EQ(landed.sequence, 4);
  EXPECT_GT(landed.tick, 2700 + 200) << "after the double support";
}

TEST(TouchDownMoveTest, TickThatIsNotInTheSupportBreaksTheContract) {
  const GaitSetup setup = Walking();
  const GaitSupport support = SupportAt(setup, 1800);
  EXPECT_THROW(MoveTouchDown(setup, support, 1799, {2, 10}, kLeast), ContractViolation);
  EXPECT_THROW(MoveTouchDown(setup, support, 2600, {2, 10}, kLeast), ContractViolation);
}

}  // namespace
}  // namespace sidestep::touch_down_move_test
