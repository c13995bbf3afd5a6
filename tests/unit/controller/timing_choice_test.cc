// SPDX-License-Identifier: BSD-3-Clause
#include "controller/timing_choice.h"

#include <gtest/gtest.h>

#include "controller/make_stages.h"
#include "controller/planner/gait_generator.h"
#include "tests/unit/controller/two_soles.h"

namespace sidestep::timing_choice_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kMass_kg = 50.0;
constexpr double kHeight_m = 0.55;
// The left foot is in the air from 0.1 s to 0.5 s.
constexpr Tick kInTheAir = 200, kLanding = 500;

MpcParams Mpc() {
  MpcParams params;
  params.step_s = 0.05;
  params.knots = 30;
  params.friction = 0.5;
  params.weights.com << 2000, 2000, 1e5;
  params.weights.angular_momentum.setConstant(5000);
  return params;
}

GaitSetup Walk() {
  GaitParams walk;
  walk.type = GaitType::kWalk;
  walk.step_width_m = 0.2;
  walk.swing_s = 0.4;
  walk.double_support_s = 0.1;
  GaitGeometry geometry;
  geometry.num_feet = 2;
  geometry.com_height_m = kHeight_m;
  geometry.box_lower_m << -0.4, -0.02, 0.0;
  geometry.box_upper_m << 0.4, 0.3, 0.0;
  geometry.sway.share = 0.5;
  return {{walk}, geometry, kTick_s};
}

class TimingChoiceTest : public testing::Test {
 protected:
  TimingChoiceTest() {
    timing_.error_m = 0.04;
    state_.feet.resize(2);
    state_.feet[0].p_WF = {0.0, 0.1, 0.0};
    state_.feet[1].p_WF = {0.0, -0.1, 0.0};
  }

  /// The course chosen at `tick` by a robot that is on its path and `push_mps` faster than it.
  std::optional<GaitSupport> Choose(Tick tick, const Eigen::Vector3d& push_mps) {
    GaitPlanner planner(Walk(), {}, 1600);
    mpc::CentroidalMpc mpc(Mpc(), PlannedRobot(TwoSoles(kMass_kg, kHeight_m), kMass_kg), kTick_s);
    TimingChoice choice(timing_, Mpc(), kHeight_m, kMass_kg, kTick_s);
    for (Tick now = 0; now <= tick; now += 50) {
      for (std::size_t foot = 0; foot < 2; ++foot) {
        state_.feet[foot].in_contact = foot == 1 || now < 100;
      }
      planner.Update(state_, now);
      const ComReference nominal = planner.ReferenceAt(now);
      state_.p_WC = nominal.p_WC;
      state_.v_WC = nominal.v_WC + (now == tick ? push_mps : Eigen::Vector3d::Zero());
      mpc::GridReferences references;
      SampleReferences(planner.schedule(), mpc.GridAt(planner.plan(), now), Eigen::Vector3d::Zero(),
                       Mpc(), kTick_s, &references);
      if (now < tick) mpc.Solve(state_, planner.plan(), references, now);
      mpc.Activate(now);
    }
    const int newest = static_cast<int>(mpc.footholds().size());
    auto chosen = choice.Choose(state_, planner, Eigen::Vector3d::Zero(), tick, &mpc);
    EXPECT_FALSE(mpc.Activate(tick)) << "the plan in use has changed";
    EXPECT_EQ(static_cast<int>(mpc.footholds().size()), newest);
    return chosen;
  }

  static Tick LandingOf(const GaitSupport& support) { return NextSupport(Walk(), support)->tick; }

  TimingParams timing_;
  RobotState state_;
};

TEST_F(TimingChoiceTest, OnItsPathAWalkGoesByTheClock) {
  for (const Tick tick : {50, 150, 200, 300, 400}) {
    EXPECT_FALSE(Choose(tick, Eigen::Vector3d::Zero())) << tick;
  }
}

TEST_F(TimingChoiceTest, BelowItsThresholdItGoesByTheClockToo) {
  timing_.error_m = 0.2;  // 0.5 m/s are 0.12 m of the capture point
  EXPECT_FALSE(Choose(kInTheAir, {0.0, 0.5, 0.0}));
}

TEST_F(TimingChoiceTest, ZeroSwitchesItOff) {
  timing_.error_m = 0.0;
  EXPECT_FALSE(Choose(kInTheAir, {0.0, 2.0, 0.0}));
}

TEST_F(TimingChoiceTest, PushedTowardsTheFootInTheAirItLandsSooner) {
  const auto chosen = Choose(kInTheAir, {0.0, 0.6, 0.0});
  ASSERT_TRUE(chosen);
  EXPECT_LT(LandingOf(*chosen), kLanding);
  EXPECT_GE(LandingOf(*chosen), kInTheAir + 100);
}

TEST_F(TimingChoiceTest, ChoosesTheSameAgain) {
  const auto one = Choose(kInTheAir, {0.3, 0.5, 0.0});
  const auto other = Choose(kInTheAir, {0.3, 0.5, 0.0});
  ASSERT_TRUE(one && other);
  EXPECT_EQ(LandingOf(*one), LandingOf(*other));
  EXPECT_EQ(one->orders.next[1].first_foot, other->orders.next[1].first_foot);
}

TEST_F(TimingChoiceTest, WhatSavesLessThanTheGainIsNotTaken) {
  timing_.gain = 1.0;
  EXPECT_FALSE(Choose(kInTheAir, {0.0, 0.6, 0.0}));
}

}  // namespace
}  // namespace sidestep::timing_choice_test
