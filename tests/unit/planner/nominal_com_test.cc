// SPDX-License-Identifier: BSD-3-Clause
// NominalComAt: the CoM's motion along a schedule that was written by hand.
#include <gtest/gtest.h>

#include "controller/planner/contact_schedule.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::nominal_com_test {
namespace {

// At rest at x = 0 until 100 ms, by 0.1 m at 300 ms to rest at 0.4 m from 500 ms on.
ContactSchedule Schedule() {
  ContactSchedule schedule;
  schedule.com = {{0, {0.0, 0.0, 0.5}, 0, true},
                  {100, {0.0, 0.0, 0.5}, 0, true},
                  {300, {0.1, 0.0, 0.5}, 0, false},
                  {500, {0.4, 0.0, 0.5}, 1, true}};
  return schedule;
}

double X(Tick tick) { return NominalComAt(Schedule(), tick, kTick_s).p_WC.x(); }
double Vx(Tick tick) { return NominalComAt(Schedule(), tick, kTick_s).v_WC.x(); }

TEST(NominalComTest, PassesThroughTheKnots) {
  EXPECT_EQ(X(100), 0.0);
  EXPECT_EQ(X(300), 0.1);
  EXPECT_NEAR(X(499), 0.4, 1e-5);
  EXPECT_EQ(X(500), 0.4);
}

TEST(NominalComTest, SpeedAtAKnotIsItsNeighboursDistanceOverTheirTime) {
  EXPECT_NEAR(Vx(300), 0.4 / 0.4, 1e-12);
  EXPECT_EQ(Vx(100), 0.0) << "at rest, whatever its neighbours";
}

TEST(NominalComTest, BetweenRestingKnotsOfOnePlaceNothingMoves) {
  for (Tick tick = 0; tick <= 100; ++tick) {
    EXPECT_EQ(X(tick), 0.0) << tick;
    EXPECT_EQ(Vx(tick), 0.0) << tick;
  }
}

TEST(NominalComTest, RestsBeforeTheFirstKnotAndAfterTheLast) {
  for (const Tick tick : {-1000, -1}) EXPECT_EQ(X(tick), 0.0);
  for (const Tick tick : {500, 501, 100000}) {
    EXPECT_EQ(X(tick), 0.4);
    EXPECT_EQ(Vx(tick), 0.0);
  }
}

TEST(NominalComTest, IsTheSameWithoutKnotsThatAreTwoAway) {
  ContactSchedule cut = Schedule();
  cut.com.erase(cut.com.begin());
  for (Tick tick = 100; tick < 500; ++tick) {
    EXPECT_EQ(NominalComAt(cut, tick, kTick_s).p_WC.x(), X(tick)) << tick;
  }
  cut.com.pop_back();
  EXPECT_NE(NominalComAt(cut, 250, kTick_s).p_WC.x(), X(250)) << "the neighbour sets the speed";
}

}  // namespace
}  // namespace sidestep::nominal_com_test
