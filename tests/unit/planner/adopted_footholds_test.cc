// SPDX-License-Identifier: BSD-3-Clause
// What the planner is told back: footholds of the MPC, and another course of things.
#include <gtest/gtest.h>

#include <random>

#include "controller/planner/gait_planner.h"
#include "controller/planner/schedule_edits.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::adopted_footholds_test {
namespace {

constexpr Tick kHorizon = 1500;
constexpr Tick kEnd = 6000;

GaitPlanner Walking(FollowMode follow) {
  PlannerParams params;
  params.follow = follow;
  params.min_step_width_m = 0.12;
  return {SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 0.5),
                   Stretch(GaitType::kRun, 3.0)},
                  2),
          params, kHorizon};
}

/// A belief that wanders; feet are felt at random.
class Wanderer {
 public:
  double Draw(double reach) { return std::uniform_real_distribution(-reach, reach)(random_); }
  Eigen::Vector3d Near(const Eigen::Vector3d& p_WF) {
    return p_WF + Eigen::Vector3d(Draw(0.05), Draw(0.05), 0.0);
  }
  RobotState State() {
    RobotState state;
    state.p_WC = {Draw(0.1), Draw(0.1), kComHeight_m};
    state.v_WC = {Draw(0.3), Draw(0.3), 0.0};
    state.feet.resize(2);
    for (FootState& foot : state.feet) {
      foot.p_WF = {Draw(0.3), Draw(0.3), 0.0};
      foot.in_contact = Draw(1.0) > 0.0;
    }
    return state;
  }

 private:
  std::mt19937 random_{7};
};

bool AreSame(const ContactPlan& a, const ContactPlan& b) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (a.feet[foot].size() != b.feet[foot].size()) return false;
    for (std::size_t i = 0; i < a.feet[foot].size(); ++i) {
      const PlannedContact& left = a.feet[foot][i];
      const PlannedContact& right = b.feet[foot][i];
      const bool same =
          left.index == right.index && left.start_tick == right.start_tick &&
          left.end_tick == right.end_tick && left.nominal_p_WF == right.nominal_p_WF &&
          left.adjusted_p_WF == right.adjusted_p_WF && left.box_lower_m == right.box_lower_m &&
          left.box_upper_m == right.box_upper_m;
      if (!same) return false;
    }
  }
  return true;
}

class AdoptedFootholdsTest : public testing::TestWithParam<FollowMode> {};

TEST_P(AdoptedFootholdsTest, PlanIsWhatASecondUpdateOfThatTickWouldGive) {
  GaitPlanner planner = Walking(GetParam());
  Wanderer wanderer;
  int changed = 0;
  for (Tick tick = 0; tick < kEnd; tick += 10) {
    const RobotState state = wanderer.State();
    const ContactPlan before = planner.Update(state, tick);
    for (int foot = 0; foot < 2; ++foot) {
      for (const PlannedContact& contact : before.feet[static_cast<std::size_t>(foot)]) {
        planner.AdoptFootholds({{foot, contact.index, wanderer.Near(contact.adjusted_p_WF)}});
      }
    }
    GaitPlanner again = planner;
    again.Update(state, tick);
    ASSERT_TRUE(AreSame(planner.plan(), again.plan())) << tick;
    for (const Tick ask : {tick, tick + 700}) {
      ASSERT_EQ(planner.ReferenceAt(ask).p_WC, again.ReferenceAt(ask).p_WC) << tick;
    }
    changed += AreSame(before, planner.plan()) ? 0 : 1;
  }
  EXPECT_EQ(changed, kEnd / 10) << "a foothold that changes nothing was not adopted";
}

TEST_P(AdoptedFootholdsTest, CopyGoesOnLikeItsOriginal) {
  GaitPlanner planner = Walking(GetParam());
  Wanderer wanderer;
  for (Tick tick = 0; tick < 2000; tick += 10) {
    planner.Update(wanderer.State(), tick);
    planner.AdoptFootholds({{0, planner.plan().feet[0].back().index, {0.1, 0.1, 0.0}}});
  }
  auto copy = std::make_unique<GaitPlanner>(planner);
  GaitPlanner other = *copy;
  copy.reset();  // a pointer into the first copy would dangle
  for (Tick tick = 2000; tick < kEnd; tick += 10) {
    const RobotState state = wanderer.State();
    planner.Update(state, tick);
    other.Update(state, tick);
    ASSERT_TRUE(AreSame(planner.plan(), other.plan())) << tick;
  }
}

INSTANTIATE_TEST_SUITE_P(Follow, AdoptedFootholdsTest,
                         testing::Values(FollowMode::kPath, FollowMode::kCapturePoint));

TEST(AdoptedFootholdTest, FeltFootStaysWhereItIsFeltAndUnfeltOneGoes) {
  GaitPlanner planner = Walking(FollowMode::kPath);
  Wanderer wanderer;
  RobotState state = wanderer.State();
  state.feet[0].in_contact = true;
  state.feet[1].in_contact = false;
  planner.Update(state, 100);
  const Eigen::Vector3d decided(0.01, 0.02, 0.0);
  planner.AdoptFootholds({{0, 0, decided}});
  planner.AdoptFootholds({{1, 0, decided}});
  EXPECT_EQ(planner.plan().feet[0][0].adjusted_p_WF, state.feet[0].p_WF);
  EXPECT_EQ(planner.plan().feet[1][0].adjusted_p_WF, decided);
}

TEST(AdoptedFootholdTest, ContactThatIsNotInThePlanIsPassedOver) {
  GaitPlanner planner = Walking(FollowMode::kPath);
  Wanderer wanderer;
  const ContactPlan before = planner.Update(wanderer.State(), 100);
  for (const int index : {-1, 7, 1000}) planner.AdoptFootholds({{0, index, {9.0, 9.0, 9.0}}});
  EXPECT_TRUE(AreSame(planner.plan(), before));
  for (Tick tick = 110; tick < kEnd; tick += 10) {
    for (const PlannedContact& contact : planner.Update(wanderer.State(), tick).feet[0]) {
      EXPECT_LT(contact.adjusted_p_WF.norm(), 5.0) << "remembered after all";
    }
  }
}

TEST(AdoptTest, PlannerGoesOnAsTheEditSays) {
  GaitPlanner planner = Walking(FollowMode::kPath);
  Wanderer wanderer;
  RobotState state = wanderer.State();
  Tick tick = 0;
  for (; tick <= 1000; ++tick) planner.Update(state, tick);  // the left foot is in the air
  --tick;
  const auto later = MoveTouchDown(planner.setup(), planner.support(), tick,
                                   {planner.support().sequence + 1, 70}, 200);
  ASSERT_TRUE(later.has_value());
  ContactSchedule laid_out;
  planner.LayOut(*later, &laid_out);
  const Tick was = planner.plan().feet[0].front().start_tick;
  EXPECT_EQ(laid_out.feet[0].front().contact.start_tick, was + 70);
  EXPECT_EQ(planner.plan().feet[0].front().start_tick, was) << "only asked";
  planner.Adopt(*later);
  EXPECT_EQ(planner.plan().feet[0].front().start_tick, was + 70);
  planner.Update(state, was + 10);
  EXPECT_GT(planner.plan().feet[0].front().start_tick, was) << "still in the air";
  planner.Update(state, was + 70);
  EXPECT_EQ(planner.support().tick, was + 70);
}

TEST(AdoptTest, DecisionStaysIfThePlaceStaysAndGoesWithIt) {
  for (const bool stops : {false, true}) {
    GaitPlanner planner = Walking(FollowMode::kPath);
    Wanderer wanderer;
    for (Tick tick = 0; tick <= 1000; ++tick) planner.Update(wanderer.State(), tick);
    const int next = planner.plan().feet[0].front().index;
    const Eigen::Vector3d decided(0.12, 0.09, 0.0);
    planner.AdoptFootholds({{0, next, decided}});
    planner.Adopt(stops ? StopNow(planner.setup(), planner.support(), 1000)
                        : *MoveTouchDown(planner.setup(), planner.support(), 1000, {1, 20}, 200));
    const PlannedContact& contact = planner.plan().feet[0].front();
    ASSERT_EQ(contact.index, next);
    EXPECT_EQ(contact.adjusted_p_WF, stops ? contact.nominal_p_WF : decided);
  }
}

}  // namespace
}  // namespace sidestep::adopted_footholds_test
