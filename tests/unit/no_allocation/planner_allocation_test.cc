// SPDX-License-Identifier: BSD-3-Clause
// A planner that walks, and is asked for other courses of things at every tick, takes no memory.
#include <gtest/gtest.h>

#include "controller/planner/gait_planner.h"
#include "controller/planner/schedule_edits.h"
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
  std::vector<Foothold> decided{{0, 0, {0.1, 0.1, 0.0}}};
  const std::int64_t before = CountAllocations();
  std::size_t most = 0;
  for (Tick tick = 0; tick < kEnd; ++tick) {
    const auto& contacts = planner.Update(state, tick).feet[0];
    decided[0].index = contacts.back().index;
    planner.AdoptFootholds(decided);
    most = std::max(most, planner.plan().feet[0].size());
  }
  EXPECT_EQ(CountAllocations() - before, 0);
  EXPECT_EQ(most, 40U + 1U) << "1600 ticks of steps of 20 by two feet";
}

TEST(PlannerAllocationTest, AskingForOtherSchedulesTakesNoMemory) {
  GaitPlanner planner(Everything(), {}, kHorizon);
  const RobotState state = Somewhere();
  const GaitParams walk = Stretch(GaitType::kWalk, 0.0);
  ContactSchedule candidate;
  planner.LayOut(planner.support(), &candidate);
  int asked = 0;
  const auto look = [&](const std::optional<GaitSupport>& edited) {
    if (!edited) return;
    planner.LayOut(*edited, &candidate);
    ++asked;
  };
  const std::int64_t before = CountAllocations();
  for (Tick tick = 0; tick < kEnd; tick += 10) {
    planner.Update(state, tick);
    const GaitSetup& setup = planner.setup();
    const GaitSupport& now = planner.support();
    for (const Tick by : {-200, -100, 100, 200}) {
      look(MoveTouchDown(setup, now, tick, {now.sequence + 1, by}, 200));
    }
    look(StopNow(setup, now, tick));
    look(StartNow(setup, now, tick, walk, 1));
    look(StepOnTheSpot(setup, now, tick, {3, 0.02, 0.0, 0}));
  }
  EXPECT_EQ(CountAllocations() - before, 0);
  EXPECT_GT(asked, kEnd / 10 * 3);
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
