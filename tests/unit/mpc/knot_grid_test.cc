// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/knot_grid.h"

#include <gtest/gtest.h>

#include "models/support/require.h"

namespace sidestep::mpc::knot_grid_test {
namespace {

constexpr Tick kStep = 50;

TEST(KnotGridTest, ASolveOnTheGridHasEqualKnots) {
  for (const Tick grid_tick : {-150, 0, 50, 100, 1000}) {
    const KnotGrid grid(100, grid_tick, kStep);
    for (int k = 0; k < 5; ++k) {
      EXPECT_EQ(grid.TickOf(k), 100 + k * kStep) << grid_tick;
      EXPECT_EQ(grid.StepAt(k), kStep) << grid_tick;
      EXPECT_EQ(grid.StepsTo(k), k) << "exactly, for nothing may change on the grid";
    }
  }
}

TEST(KnotGridTest, ASolveOffTheGridReachesItAtItsFirstKnot) {
  // 113 and 120 are on the grid of 13 and 20.
  for (const Tick grid_tick : {-37, 13, 113, 163, 513}) {
    const KnotGrid grid(120, grid_tick, kStep);
    EXPECT_EQ(grid.start(), 120);
    EXPECT_EQ(grid.StepAt(0), 43) << grid_tick;
    EXPECT_EQ(grid.StepAt(1), kStep) << grid_tick;
    EXPECT_EQ(grid.TickOf(0), 120) << grid_tick;
    EXPECT_EQ(grid.TickOf(1), 163) << grid_tick;
    EXPECT_EQ(grid.TickOf(3), 263) << grid_tick;
  }
}

TEST(KnotGridTest, TheFirstKnotLastsFromOneTickToAWholeStepWheneverTheSolveIs) {
  for (Tick start = -120; start < 120; ++start) {
    const KnotGrid grid(start, 7, kStep);
    EXPECT_GE(grid.StepAt(0), 1) << start;
    EXPECT_LE(grid.StepAt(0), kStep) << start;
    EXPECT_EQ((grid.TickOf(1) - 7) % kStep, 0) << start;
  }
}

TEST(KnotGridTest, StepsToAKnotAreItsTimeInSteps) {
  const KnotGrid grid(40, 0, kStep);
  EXPECT_EQ(grid.StepsTo(0), 0.0);
  EXPECT_DOUBLE_EQ(grid.StepsTo(1), 0.2);
  EXPECT_DOUBLE_EQ(grid.StepsTo(4), 3.2);
}

TEST(KnotGridTest, AKnotIsOnFromItsTickUntilBeforeTheNext) {
  const KnotGrid grid(20, 0, kStep);  // Knots at 20, 50, 100, ...
  EXPECT_EQ(grid.KnotAt(-1000), 0);
  EXPECT_EQ(grid.KnotAt(20), 0);
  EXPECT_EQ(grid.KnotAt(49), 0);
  EXPECT_EQ(grid.KnotAt(50), 1);
  EXPECT_EQ(grid.KnotAt(99), 1);
  EXPECT_EQ(grid.KnotAt(100), 2);
  EXPECT_EQ(grid.KnotAt(1049), 20);
}

TEST(KnotGridTest, EveryKnotIsTheOneAtItsTickAndNearestToIt) {
  for (Tick start = 0; start < 2 * kStep; ++start) {
    const KnotGrid grid(start, 13, kStep);
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(grid.KnotAt(grid.TickOf(k)), k) << start;
      EXPECT_EQ(grid.NearestKnot(grid.TickOf(k)), k) << start;
      EXPECT_EQ(grid.KnotAt(grid.TickOf(k + 1) - 1), k) << start;
    }
  }
}

TEST(KnotGridTest, TheNearestOfTwoKnotsIsTheLaterIfTheyAreEquallyNear) {
  const KnotGrid grid(20, 0, kStep);  // Knots at 20, 50, 100, ...
  EXPECT_EQ(grid.NearestKnot(-1000), 0);
  EXPECT_EQ(grid.NearestKnot(34), 0);
  EXPECT_EQ(grid.NearestKnot(35), 1) << "half of the short knot";
  EXPECT_EQ(grid.NearestKnot(74), 1);
  EXPECT_EQ(grid.NearestKnot(75), 2);
  EXPECT_EQ(grid.NearestKnot(124), 2);
}

TEST(KnotGridTest, AStepOfNoTicksBreaksTheContract) {
  EXPECT_THROW(KnotGrid(0, 0, 0), ContractViolation);
}

}  // namespace
}  // namespace sidestep::mpc::knot_grid_test
