// SPDX-License-Identifier: BSD-3-Clause
// What the schedule makes of feet that land before or after their time.
#include "controller/planner/touch_down_events.h"

#include <gtest/gtest.h>

#include "controller/planner/gait_planner.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::touch_down_events_test {
namespace {

// Walking from 1 s on: the left foot is in the air from 1.2 s to 1.8 s (landing 1), the right one
// from 2.0 s to 2.6 s.
constexpr Tick kLiftOff = 1200;
constexpr Tick kDue = 1800;
constexpr Tick kPeriod = 5;
constexpr double kWeightShare_N = 100.0;
constexpr TouchDownRule kFelt{true, kWeightShare_N, 100, kPeriod};

GaitSetup Walking() {
  return SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 1.0)}, 2);
}

// Both feet on the ground but the left one, which bears `load_N`; felt from 10 N on.
RobotState Loaded(double load_N) {
  RobotState state;
  state.p_WC = {0.0, 0.0, kComHeight_m};
  state.feet.resize(2);
  state.feet[0].wrench.force_N.z() = load_N;
  state.feet[0].in_contact = load_N > 10.0;
  state.feet[0].p_WF = {0.09, 0.08, 0.02};
  state.feet[1].in_contact = true;
  return state;
}

std::optional<GaitSupport> EventAt(Tick tick, double load_N, const TouchDownRule& rule = kFelt) {
  const GaitSetup setup = Walking();
  return AfterTouchDownEvent(setup, SupportAt(setup, kLiftOff), Loaded(load_N), tick, rule);
}

Tick NextLandingOf(const GaitSupport& support) { return NextSupport(Walking(), support)->tick; }

TEST(TouchDownEventsTest, LoadedFootOnItsWayDownLandsNow) {
  const auto support = EventAt(1700, kWeightShare_N + 1.0);
  ASSERT_TRUE(support.has_value());
  EXPECT_EQ(NextLandingOf(*support), 1700);
  const auto landed = NextSupport(Walking(), *support);
  EXPECT_EQ(landed->feet[0].nominal.contact.due_tick, 1700);
  EXPECT_EQ(NextLandingOf(*landed), 1700 + 800) << "the steps after it come as much earlier";
}

TEST(TouchDownEventsTest, LightTouchIsNoLanding) {
  EXPECT_FALSE(EventAt(1700, kWeightShare_N).has_value());
  EXPECT_FALSE(EventAt(1700, 0.0).has_value());
}

TEST(TouchDownEventsTest, FootThatHasNotYetLeftDoesNotLand) {
  EXPECT_FALSE(EventAt(kLiftOff, 500.0).has_value());
  EXPECT_FALSE(EventAt(kLiftOff + 299, 500.0).has_value());
  EXPECT_TRUE(EventAt(kLiftOff + 300, 500.0).has_value()) << "the middle of its swing";
}

TEST(TouchDownEventsTest, FootThatIsDueAndFeltIsNoEvent) {
  EXPECT_FALSE(EventAt(kDue, 50.0).has_value());
  EXPECT_FALSE(EventAt(kDue, 500.0).has_value());
}

TEST(TouchDownEventsTest, FootThatIsDueAndNotFeltIsWaitedFor) {
  const auto support = EventAt(kDue, 0.0);
  ASSERT_TRUE(support.has_value());
  const auto landed = NextSupport(Walking(), *support);
  EXPECT_EQ(landed->tick, kDue + kPeriod);
  EXPECT_EQ(landed->feet[0].nominal.contact.due_tick, kDue) << "its swing was to end there";
  EXPECT_EQ(NextLandingOf(*landed), kDue + kPeriod + 800);
}

TEST(TouchDownEventsTest, ByTheClockNothingIsAnEvent) {
  EXPECT_FALSE(EventAt(1700, 500.0, {}).has_value());
  EXPECT_FALSE(EventAt(kDue, 0.0, {}).has_value());
}

TEST(TouchDownEventsTest, StandHasNoLandingToMove) {
  const GaitSetup setup = SetupOf({Stretch(GaitType::kStand, 0.0)}, 2);
  EXPECT_FALSE(
      AfterTouchDownEvent(setup, StandingSupport(setup), Loaded(0.0), 500, kFelt).has_value());
}

// A planner that sees the left foot bear weight from `contact` on.
class Planner {
 public:
  explicit Planner(Tick contact)
      : contact_(contact), planner_(Walking(), PlannerParams{}, 3000, kFelt) {}

  void GoTo(Tick end) {
    for (; tick_ < end; tick_ += kPeriod) {
      const bool is_down = tick_ < kLiftOff || tick_ >= contact_;
      planner_.Update(Loaded(is_down ? 200.0 : 0.0), tick_);
      if (planner_.has_landed_early()) landings_.push_back(tick_);
    }
  }

  const PlannedContact& left() const { return planner_.plan().feet[0].front(); }
  const PlannedContact& right() const { return planner_.plan().feet[1].front(); }
  const std::vector<Tick>& landings() const { return landings_; }

 private:
  Tick contact_;
  Tick tick_{0};
  GaitPlanner planner_;
  std::vector<Tick> landings_;
};

TEST(TouchDownEventsTest, PlannerStandsOnTheFootThatLandedEarlyWhereItIs) {
  Planner planner(1650);
  planner.GoTo(1651);
  EXPECT_EQ(planner.left().index, 1);
  EXPECT_EQ(planner.left().start_tick, 1650);
  EXPECT_EQ(planner.left().adjusted_p_WF, Loaded(0.0).feet[0].p_WF);
  EXPECT_EQ(planner.right().end_tick, 1650 + 200) << "the other foot leaves as much earlier";
  EXPECT_EQ(planner.landings(), std::vector<Tick>{1650});
}

TEST(TouchDownEventsTest, PlannerWaitsAndGoesOnFromTheLanding) {
  Planner planner(1840);
  planner.GoTo(1836);
  EXPECT_EQ(planner.left().start_tick, 1840);
  EXPECT_EQ(planner.left().due_tick, kDue);
  EXPECT_EQ(planner.right().end_tick, 2040);
  EXPECT_TRUE(planner.landings().empty());
  planner.GoTo(2000);
  EXPECT_TRUE(planner.landings().empty()) << "every plan has had it as about to land";
  EXPECT_EQ(planner.right().end_tick, 2040);
}

TEST(TouchDownEventsTest, PlannerDoesNotWaitForever) {
  Planner planner(9999);
  planner.GoTo(1901);
  EXPECT_EQ(planner.left().start_tick, 1900) << "after the longest wait the clock goes on";
  EXPECT_EQ(planner.right().end_tick, 2100);
  planner.GoTo(1990);
  EXPECT_EQ(planner.right().end_tick, 2100);
}

// The left foot has landed by the clock, and the right one is to leave at 2 s.
constexpr Tick kRightLeaves = 2000;

TEST(TouchDownEventsTest, FootDoesNotLeaveTheOtherOneThatIsNotFelt) {
  const GaitSetup setup = Walking();
  const GaitSupport support = SupportAt(setup, kDue);
  const auto held = AfterHeldLiftOff(setup, support, Loaded(0.0), kRightLeaves, kFelt);
  ASSERT_TRUE(held.has_value());
  const auto landed = NextSupport(setup, *held);
  EXPECT_EQ(landed->feet[1].nominal.contact.start_tick, 2600 + kPeriod) << "all comes later";
  EXPECT_EQ(landed->feet[0].nominal.contact.start_tick, kDue) << "but for what has happened";
}

TEST(TouchDownEventsTest, FootLeavesInTimeTheOtherOneThatIsFelt) {
  const GaitSetup setup = Walking();
  const GaitSupport support = SupportAt(setup, kDue);
  EXPECT_FALSE(AfterHeldLiftOff(setup, support, Loaded(20.0), kRightLeaves, kFelt).has_value());
  EXPECT_FALSE(AfterHeldLiftOff(setup, support, Loaded(0.0), kRightLeaves - 1, kFelt).has_value())
      << "there is time yet";
  EXPECT_FALSE(
      AfterHeldLiftOff(setup, support, Loaded(0.0), kRightLeaves + kPeriod, kFelt).has_value())
      << "it has left";
  EXPECT_FALSE(AfterHeldLiftOff(setup, support, Loaded(0.0), kRightLeaves, {}).has_value())
      << "by the clock";
}

TEST(TouchDownEventsTest, FootThatLeavesIsTheOnlyOneThatWaits) {
  const GaitSetup setup = SetupOf({Stretch(GaitType::kRun, 0.0)}, 2);
  const GaitSupport support = SupportAt(setup, 450);  // a stance of 250 ticks, on one foot
  for (Tick tick = support.tick; tick < support.tick + 400; ++tick) {
    EXPECT_FALSE(AfterHeldLiftOff(setup, support, Loaded(0.0), tick, kFelt).has_value()) << tick;
  }
}

TEST(TouchDownEventsTest, PlannerHoldsTheLiftOffUntilTheFootIsFelt) {
  Planner planner(2160);  // 1.8 s, 0.1 s of waiting, 0.2 s of double support; 60 ms not felt yet
  planner.GoTo(2156);
  EXPECT_EQ(planner.left().start_tick, 1900);
  EXPECT_EQ(planner.right().end_tick, 2160);
  planner.GoTo(2300);
  EXPECT_EQ(planner.right().index, 1) << "it has left";
}

TEST(TouchDownEventsTest, PlannerDoesNotHoldTheLiftOffForever) {
  Planner planner(9999);
  planner.GoTo(2196);
  EXPECT_EQ(planner.right().end_tick, 2200) << "the longest wait once more";
  planner.GoTo(2211);
  EXPECT_EQ(planner.right().index, 1) << "after it the clock goes on";
}

TEST(TouchDownEventsTest, LandingOnTimeIsOnSchedule) {
  Planner planner(kDue - kPeriod);
  planner.GoTo(1796);
  EXPECT_EQ(planner.landings(), std::vector<Tick>{kDue - kPeriod});
  Planner on_time(kDue);
  on_time.GoTo(1900);
  EXPECT_TRUE(on_time.landings().empty());
}

}  // namespace
}  // namespace sidestep::touch_down_events_test
