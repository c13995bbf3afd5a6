// SPDX-License-Identifier: BSD-3-Clause
#include "controller/swing/foot_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "models/support/require.h"

namespace sidestep::foot_targets_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr Tick kLiftOff = 100;
constexpr Tick kLanding = 500;

const SwingShape kSwing{0.05, 0.1};

PlannedContact Contact(int index, Tick start, Tick end, const Eigen::Vector3d& p_WF) {
  PlannedContact contact;
  contact.index = index;
  contact.start_tick = contact.due_tick = start;
  contact.end_tick = end;
  contact.adjusted_p_WF = p_WF;
  contact.swing = kSwing;
  return contact;
}

// One foot that stands at (0, 0), flies from tick 100 to 500 and stands at (0.2, 0) from then on.
class OneStep {
 public:
  explicit OneStep(StandingRule rule) : targets_(1, rule, kTick_s), feet_(1) {
    feet_[0].planned_contact = true;
    feet_[0].vertex_force_N.setConstant(3, 1, 7.0);
    state_.feet.resize(1);
    state_.feet[0].p_WF = {0.01, 0.02, 0.0};  // a little off where it was planned
  }

  // Moves on to `tick`, the foot felt on the ground where `felt` says so.
  FootTarget At(Tick tick, bool felt) {
    ContactPlan plan;
    plan.feet.resize(1);
    if (tick < kLiftOff) plan.feet[0].push_back(Contact(0, 0, kLiftOff, {0.0, 0.0, 0.0}));
    plan.feet[0].push_back(Contact(1, kLanding, 9999, {0.2, 0.0, 0.0}));
    state_.feet[0].in_contact = felt;
    targets_.Update(state_, plan, tick, &feet_);
    return feet_[0];
  }

  // Flies from tick 100 on and returns the highest it was meant to be before `end`.
  double FlyUntil(Tick end) {
    At(kLiftOff - 1, true);
    double highest_m = 0.0;
    for (Tick tick = kLiftOff; tick < end; ++tick) {
      highest_m = std::max(highest_m, At(tick, false).p_WF.z());
    }
    return highest_m;
  }

 private:
  FootTargets targets_;
  RobotState state_;
  std::vector<FootTarget> feet_;
};

TEST(FootTargetsTest, AStandingFootRestsOnItsFoothold) {
  const FootTarget foot = OneStep(StandingRule::kWhenFelt).At(50, true);
  EXPECT_TRUE(foot.planned_contact);
  EXPECT_EQ(foot.p_WF, Eigen::Vector3d(0.0, 0.0, 0.0));
  EXPECT_EQ(foot.v_WF.norm() + foot.a_WF.norm(), 0.0);
  EXPECT_EQ(foot.contact.index, 0);
}

TEST(FootTargetsTest, ASwingBeginsWhereTheFootIsBelievedNotWhereItWasPlanned) {
  OneStep step(StandingRule::kWhenFelt);
  step.At(kLiftOff - 1, true);
  const FootTarget foot = step.At(kLiftOff, true);
  EXPECT_FALSE(foot.planned_contact);
  EXPECT_EQ(foot.contact.index, 1);
  EXPECT_LT((foot.p_WF - Eigen::Vector3d(0.01, 0.02, 0.0)).norm(), 1e-12);
}

TEST(FootTargetsTest, ASwingHasTheShapeOfTheContactItLeadsTo) {
  EXPECT_NEAR(OneStep(StandingRule::kWhenFelt).FlyUntil(kLanding), kSwing.height_m, 1e-9);
}

TEST(FootTargetsTest, AStandingFootThatIsNoLongerFeltGoesDownFromThenOn) {
  OneStep step(StandingRule::kWhenFelt);
  step.FlyUntil(kLanding);
  step.At(kLanding, true);
  step.At(kLanding + 3000, true);
  constexpr Tick kLost = kLanding + 3000 + 50;  // the longest dip later
  EXPECT_TRUE(step.At(kLost, false).supports);
  EXPECT_EQ(step.At(kLost, false).v_WF.norm(), 0.0);
  const FootTarget foot = step.At(kLost + 10, false);
  EXPECT_FALSE(foot.supports);
  EXPECT_LT((foot.p_WF - Eigen::Vector3d(0.2, 0.0, -0.01 * kSwing.landing_speed_mps)).norm(), 1e-9);
  EXPECT_NEAR(foot.v_WF.z(), -kSwing.landing_speed_mps, 1e-9);
  const FootTarget again = step.At(kLost + 20, true);
  EXPECT_TRUE(again.supports);
  EXPECT_EQ(again.p_WF, Eigen::Vector3d(0.2, 0.0, 0.0));
}

// Two feet that stand, of which the second is not felt any more.
bool SupportsUnfelt(double planned_N) {
  FootTargets targets(2, StandingRule::kWhenFelt, kTick_s);
  RobotState state;
  state.feet.resize(2);
  ContactPlan plan;
  plan.feet.assign(2, {Contact(0, 0, 9999, Eigen::Vector3d::Zero())});
  std::vector<FootTarget> feet(2);
  for (FootTarget& foot : feet) foot.planned_contact = true;
  feet[0].force_N.z() = 100.0;
  feet[1].force_N.z() = planned_N;
  for (Tick tick = 0; tick < 500; ++tick) {
    state.feet[0].in_contact = true;
    state.feet[1].in_contact = tick < 100;
    targets.Update(state, plan, tick, &feet);
  }
  return feet[1].supports;
}

TEST(FootTargetsTest, AFootThatIsToBearNothingIsNotSearchedForWhenItIsNoLongerFelt) {
  EXPECT_TRUE(SupportsUnfelt(0.0));
  EXPECT_TRUE(SupportsUnfelt(1.0)) << "what a solver's barrier leaves is nothing";
  EXPECT_FALSE(SupportsUnfelt(30.0));
}

TEST(FootTargetsTest, AFootThatIsDueButNotFeltGoesOnDown) {
  OneStep step(StandingRule::kWhenFelt);
  step.FlyUntil(kLanding);
  step.At(kLanding, false);
  const FootTarget foot = step.At(kLanding + 50, false);
  EXPECT_TRUE(foot.planned_contact);
  EXPECT_NEAR(foot.p_WF.z(), -0.1 * 0.05, 1e-9);  // 0.1 m/s for 50 ms
  EXPECT_NEAR(foot.v_WF.z(), -0.1, 1e-9);
}

TEST(FootTargetsTest, AFootThatIsDueAndFeltStands) {
  OneStep step(StandingRule::kWhenFelt);
  step.FlyUntil(kLanding);
  const FootTarget foot = step.At(kLanding, true);
  EXPECT_EQ(foot.p_WF, Eigen::Vector3d(0.2, 0.0, 0.0));
  EXPECT_EQ(foot.v_WF.norm(), 0.0);
}

TEST(FootTargetsTest, ByTheOtherRuleAFootStandsAsSoonAsItIsDue) {
  OneStep step(StandingRule::kAsScheduled);
  step.FlyUntil(kLanding);
  const FootTarget foot = step.At(kLanding, false);
  EXPECT_EQ(foot.p_WF, Eigen::Vector3d(0.2, 0.0, 0.0));
  EXPECT_EQ(foot.v_WF.norm(), 0.0);
}

TEST(FootTargetsTest, ForcesAreSomebodyElses) {
  OneStep step(StandingRule::kWhenFelt);
  step.FlyUntil(kLanding);
  EXPECT_EQ(step.At(kLanding, true).vertex_force_N(2, 0), 7.0);
}

TEST(FootTargetsTest, FeetOfAnotherNumberAreABrokenContract) {
  FootTargets targets(2, StandingRule::kWhenFelt, kTick_s);
  std::vector<FootTarget> one(1);
  EXPECT_THROW(targets.Update({}, {}, 0, &one), ContractViolation);
}

}  // namespace
}  // namespace sidestep::foot_targets_test
