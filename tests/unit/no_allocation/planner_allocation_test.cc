// SPDX-License-Identifier: BSD-3-Clause
// A planner that walks takes no memory.
#include <gtest/gtest.h>

#include "controller/planner/gait_planner.h"
#include "tests/support/allocation_counter.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::planner_allocation_test {
namespace {

constexpr Tick kEnd = 12000;
constexpr Tick kHorizon = 1600;

GaitSetup Everything() {
  GaitParams quick = Stretch(GaitType::kRun, 8.0);
  quick.stance_s = 0.02;  // as short as steps come
  quick.flight_s = 0.0;
  return SetupOf({Stretch(GaitType::kWalk, 0.0), Stretch(GaitType::kRun, 3.0),
                  Stretch(GaitType::kStand, 5.0), quick},
                 2);
}

RobotState Somewhere() {
  RobotState state;
  state.p_WC = {0.1, 0.05, 0.5};
  state.v_WC = {0.2, -0.1, 0.0};
  state.feet.resize(2);
  return state;
}

TEST(PlannerAllocationTest, WalkingTakesNoMemory) {
  PlannerParams params;
  params.follow = FollowMode::kCapturePoint;
  GaitPlanner planner(Everything(), params, kHorizon);
  const RobotState state = Somewhere();
  const std::int64_t before = CountAllocations();
  std::size_t most = 0;
  for (Tick tick = 0; tick < kEnd; ++tick) {
    const auto& contacts = planner.Update(state, tick).feet[0];
    planner.AdoptFoothold(0, contacts.back().index, {0.1, 0.1, 0.0});
    most = std::max(most, planner.plan().feet[0].size());
  }
  EXPECT_EQ(CountAllocations() - before, 0);
  EXPECT_EQ(most, 40U + 1U) << "1600 ticks of steps of 20 by two feet";
}

TEST(PlannerAllocationTest, CopyTakesItsMemoryAtItsFirstTick) {
  const GaitPlanner planner(Everything(), {}, kHorizon);
  GaitPlanner copy = planner;
  const RobotState state = Somewhere();
  const std::int64_t before = CountAllocations();
  copy.Update(state, 0);
  const std::int64_t after = CountAllocations();
  EXPECT_GT(after, before) << "else this test says nothing";
  for (Tick tick = 1; tick < kEnd; ++tick) copy.Update(state, tick);
  EXPECT_EQ(CountAllocations() - after, 0);
}

}  // namespace
}  // namespace sidestep::planner_allocation_test
