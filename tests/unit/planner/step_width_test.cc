// SPDX-License-Identifier: BSD-3-Clause
// min_step_width_m: how near the next foot may land to the one that stands.
#include <gtest/gtest.h>

#include "controller/planner/gait_planner.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::step_width_test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kHalfWidth_m = 0.08;
// Of planner_test_support.h, for the left foot; the right one's is mirrored.
constexpr double kInwards_m = -0.05, kOutwards_m = 0.15;
// On the spot from 1 s on: the left foot is in the air from 1.2 s to 1.8 s, the right one from
// 2.0 s to 2.6 s.
constexpr Tick kLeftSwings = 1500, kRightSwings = 2300;

class StepWidthTest : public testing::Test {
 protected:
  StepWidthTest() { params_.min_step_width_m = 0.12; }

  /// The plan at `tick`, the feet where the belief has them.
  ContactPlan PlanAt(Tick tick) {
    GaitParams walk = Stretch(GaitType::kWalk, 1.0);
    walk.step_length_m = 0.0;
    GaitPlanner planner(SetupOf({Stretch(GaitType::kStand, 0.0), walk}, 2), params_, 3000);
    ContactPlan plan = planner.Update(state_, 0);
    for (Tick now = 100; now <= tick; now += 100) {
      state_.feet[0].in_contact = now < 1200 || now >= 1800;
      state_.feet[1].in_contact = now < 2000 || now >= 2600;
      plan = planner.Update(state_, now);
    }
    return plan;
  }

  static RobotState AtTheStart() {
    RobotState state;
    state.p_WC = {0.0, 0.0, kComHeight_m};
    state.feet.resize(2);
    state.feet[0].p_WF = {0.0, kHalfWidth_m, kSoleHeight_m};
    state.feet[1].p_WF = {0.0, -kHalfWidth_m, kSoleHeight_m};
    return state;
  }

  PlannerParams params_;
  RobotState state_{AtTheStart()};
};

TEST_F(StepWidthTest, LeftFootMayComeAsNearToTheRightAsTheWidthAllows) {
  const PlannedContact next = PlanAt(kLeftSwings).feet[0].front();
  ASSERT_EQ(next.start_tick, 1800);
  // From +0.08 inwards to 0.12 from -0.08: 4 cm instead of 5.
  EXPECT_NEAR(next.box_lower_m.y(), -0.04, kRounding);
  EXPECT_EQ(next.box_upper_m.y(), kOutwards_m);
}

TEST_F(StepWidthTest, RightFootMayComeAsNearToTheLeftAsTheWidthAllows) {
  const PlannedContact next = PlanAt(kRightSwings).feet[1].front();
  ASSERT_EQ(next.start_tick, 2600);
  EXPECT_NEAR(next.box_upper_m.y(), 0.04, kRounding);
  EXPECT_EQ(next.box_lower_m.y(), -kOutwards_m);
}

TEST_F(StepWidthTest, FootThatStandsFurtherInPushesTheOtherOut) {
  state_.feet[1].p_WF.y() = -0.02;
  EXPECT_NEAR(PlanAt(kLeftSwings).feet[0].front().box_lower_m.y(), 0.02, kRounding)
      << "to +0.10 at least";
  state_ = AtTheStart();
  state_.feet[0].p_WF.y() = 0.01;
  EXPECT_NEAR(PlanAt(kRightSwings).feet[1].front().box_upper_m.y(), -0.03, kRounding)
      << "to -0.11 at least";
}

TEST_F(StepWidthTest, BoxThatIsOutOfReachShrinksToItsNearestLineAndIsNeverInsideOut) {
  state_.feet[1].p_WF.y() = 0.30;  // crossed far over
  const PlannedContact left = PlanAt(kLeftSwings).feet[0].front();
  EXPECT_NEAR(left.box_lower_m.y(), 0.34, kRounding);
  EXPECT_EQ(left.box_upper_m.y(), left.box_lower_m.y());
  state_ = AtTheStart();
  state_.feet[0].p_WF.y() = -0.30;
  const PlannedContact right = PlanAt(kRightSwings).feet[1].front();
  EXPECT_NEAR(right.box_upper_m.y(), -0.34, kRounding);
  EXPECT_EQ(right.box_lower_m.y(), right.box_upper_m.y());
}

TEST_F(StepWidthTest, OnlyTheNextLandingIsClippedAndOnlyAside) {
  state_.feet[1].p_WF.y() = -0.02;
  const ContactPlan plan = PlanAt(kLeftSwings);
  EXPECT_EQ(plan.feet[0][0].box_lower_m.x(), -0.1);
  EXPECT_EQ(plan.feet[0][0].box_upper_m.x(), 0.2);
  EXPECT_EQ(plan.feet[0][0].box_lower_m.z(), -0.01);
  EXPECT_EQ(plan.feet[0][0].box_upper_m.z(), 0.02);
  ASSERT_GT(plan.feet[0].size(), 1U);
  EXPECT_EQ(plan.feet[0][1].box_lower_m.y(), kInwards_m) << "the landing after it";
  ASSERT_GT(plan.feet[1].size(), 1U);
  EXPECT_EQ(plan.feet[1][0].box_upper_m.y(), -kInwards_m) << "the foot that stands";
  EXPECT_EQ(plan.feet[1][1].box_upper_m.y(), -kInwards_m)
      << "the right foot lands beside a left foot that is not down yet";
}

TEST_F(StepWidthTest, FeetThatStandAreNotClippedByEachOther) {
  state_.feet[0].p_WF.y() = -0.04;
  const ContactPlan plan = PlanAt(1900);  // the left foot landed at 1.8 s, the right one goes next
  EXPECT_EQ(plan.feet[0][0].start_tick, 1800);
  EXPECT_EQ(plan.feet[0][0].box_lower_m.y(), kInwards_m);
  EXPECT_EQ(plan.feet[1][0].box_upper_m.y(), -kInwards_m);
  EXPECT_NEAR(plan.feet[1][1].box_upper_m.y(), -0.08, kRounding) << "to -0.16 at least";
}

TEST_F(StepWidthTest, WithoutAWidthBoxesAreTheGaits) {
  params_.min_step_width_m = 0.0;
  EXPECT_EQ(PlanAt(kLeftSwings).feet[0].front().box_lower_m.y(), kInwards_m);
}

TEST_F(StepWidthTest, WidthThatIsKeptAnywayChangesNothing) {
  params_.min_step_width_m = 0.10;
  EXPECT_EQ(PlanAt(kLeftSwings).feet[0].front().box_lower_m.y(), kInwards_m)
      << "5 cm inwards leave 11";
}

TEST(StepWidthOfOneFootTest, HopperHasNoWidth) {
  PlannerParams params;
  params.min_step_width_m = 0.5;
  GaitPlanner planner(SetupOf({Stretch(GaitType::kHop, 0.0)}, 1), params, 1000);
  RobotState state;
  state.feet.resize(1);
  for (const PlannedContact& contact : planner.Update(state, 0).feet[0]) {
    EXPECT_EQ(contact.box_lower_m.y(), kInwards_m);
    EXPECT_EQ(contact.box_upper_m.y(), kOutwards_m);
  }
}

}  // namespace
}  // namespace sidestep::step_width_test
