// SPDX-License-Identifier: BSD-3-Clause
// A planner that steps from standing, again and again, takes no memory once it is there.
#include <gtest/gtest.h>

#include "controller/planner/gait_planner.h"
#include "tests/support/allocation_counter.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::recovery_allocation_test {
namespace {

constexpr Tick kEnd = 20000;

TEST(RecoveryAllocationTest, StepsThatAreInsertedTakeNoMemory) {
  const std::vector<GaitParams> stand{Stretch(GaitType::kStand, 0.0)};
  Eigen::Matrix3Xd sole(3, 2);
  sole << 0.1, -0.1, 0.0, 0.0, 0.0, 0.0;
  PlannerParams params;
  params.recovery.enabled = true;
  params.recovery.steps = 1;
  GaitPlanner planner(BuildNominalGait(stand, Geometry(2), kEnd, kTick_s), params, 1000, kTick_s);
  planner.EnableRecovery({stand, Geometry(2), kEnd, 50, 10.0, {sole, sole}});
  RobotState state;  // runs away from its feet for good
  state.p_WC = {0.0, 0.0, 0.5};
  state.v_WC.x() = 2.0;
  state.feet.resize(2);
  for (FootState& foot : state.feet) foot.in_contact = true;
  state.feet[0].p_WF.y() = 0.08;
  state.feet[1].p_WF.y() = -0.08;

  int last_index = 0;
  const std::int64_t before = CountAllocations();
  for (Tick tick = 0; tick < kEnd; tick += 10) {
    last_index = planner.Update(state, tick).feet[1].back().index;
  }
  EXPECT_EQ(CountAllocations() - before, 0);
  EXPECT_GT(last_index, 20) << "it hardly steps";
}

}  // namespace
}  // namespace sidestep::recovery_allocation_test
