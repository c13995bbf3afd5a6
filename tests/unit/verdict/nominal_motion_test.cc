// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/nominal_motion.h"

#include <gtest/gtest.h>

#include "controller/planner/bounce.h"
#include "models/support/require.h"
#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::nominal_motion_test {
namespace {

// Stands for 0.5 s, then hops 0.09 m every 0.3 s.
Scenario HopScenario() {
  Scenario scenario = OneFootScenario();
  scenario.duration_s = 4.0;
  scenario.gait.resize(2);
  scenario.gait[1].type = GaitType::kHop;
  scenario.gait[1].start_s = 0.5;
  scenario.gait[1].stance_s = scenario.gait[1].flight_s = 0.15;
  scenario.gait[1].step_length_m = 0.09;
  return scenario;
}

TEST(NominalMotionTest, StandsThenHopsAtTheGaitsSpeed) {
  const NominalMotion nominal = NominalOf(HopScenario());
  EXPECT_EQ(nominal.ComAt(0).p_WC, Eigen::Vector3d(0.0, 0.0, 0.5));
  EXPECT_EQ(nominal.ComAt(400).v_WC.norm(), 0.0);
  // In the middle of a stance the CoM is over its foot: the contact from 2000 on is the fifth
  // hop's.
  const ComReference at = nominal.ComAt(2075);
  EXPECT_NEAR(at.p_WC.x(), 0.45, 1e-12);
  EXPECT_NEAR(at.v_WC.x(), 0.3, 1e-12);
  const double depth_m = BounceOf(HopScenario().gait.back()).depth_m;
  EXPECT_NEAR(at.p_WC.z(), 0.5 - depth_m, 1e-12);
  EXPECT_EQ(nominal.contacts(0).at(5).start_tick, 2000);
  EXPECT_NEAR(nominal.contacts(0).at(5).nominal_p_WF.x(), 0.45, 1e-12);
}

TEST(NominalMotionTest, GoesOnBeyondTheDuration) {
  const NominalMotion nominal = NominalOf(HopScenario());
  EXPECT_GE(nominal.end_tick(), 4000 + 1000);
  EXPECT_NEAR(nominal.ComAt(4400 + 75).v_WC.x(), 0.3, 1e-12);
}

TEST(NominalMotionTest, IsTheScenariosWhateverItsControllerPlans) {
  Scenario scenario = HopScenario();
  const NominalMotion nominal = NominalOf(scenario);
  scenario.control.planner.follow = FollowMode::kCapturePoint;
  scenario.control.external_wrench = ExternalWrenchKnowledge::kKnown;
  scenario.control.mpc.box_upper_m = {0.3, 0.2, 0.0};
  const NominalMotion other = NominalOf(scenario);
  for (Tick tick = 0; tick < 4000; tick += 37) {
    EXPECT_EQ(nominal.ComAt(tick).p_WC, other.ComAt(tick).p_WC) << tick;
  }
  EXPECT_TRUE(other.contacts(0).at(1).box_upper_m.isZero()) << "the box is no part of the gait";
}

TEST(NominalMotionTest, SwayMovesTheComAndNoFoothold) {
  Scenario scenario = TwoFeetScenario();
  const NominalMotion straight = NominalOf(scenario);
  scenario.control.planner.sway.share = 0.5;
  const NominalMotion swaying = NominalOf(scenario);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    EXPECT_EQ(straight.starts(foot), swaying.starts(foot));
    for (std::size_t i = 0; i < straight.starts(foot).size(); ++i) {
      EXPECT_EQ(straight.StepTo(foot, i), swaying.StepTo(foot, i));
    }
  }
}

TEST(NominalMotionTest, SwayIsTowardsTheFootThatStands) {
  Scenario scenario = TwoFeetScenario();
  EXPECT_NEAR(NominalOf(scenario).ComAt(1300).p_WC.y(), 0.0, 1e-12);
  scenario.control.planner.sway.share = 0.5;
  // The right foot flies from 1000 to 1600: by hand, half way to the left foot at y = 0.08.
  EXPECT_NEAR(NominalOf(scenario).ComAt(1300).p_WC.y(), 0.04, 1e-12);
}

TEST(NominalMotionTest, StepOfTwoFeetGoesFromTheOtherFoot) {
  const NominalMotion nominal = NominalOf(TwoFeetScenario());
  EXPECT_LT((nominal.StepTo(0, 0) - Eigen::Vector3d(0.0, 0.16, 0.0)).norm(), 1e-12);
  EXPECT_LT((nominal.StepTo(1, 0) - Eigen::Vector3d(0.0, -0.16, 0.0)).norm(), 1e-12);
  EXPECT_LT((nominal.StepTo(0, 1) - Eigen::Vector3d(0.1, 0.16, 0.0)).norm(), 1e-12);
  EXPECT_LT((nominal.StepTo(1, 2) - Eigen::Vector3d(0.1, -0.16, 0.0)).norm(), 1e-12);
}

TEST(NominalMotionTest, StepOfOneFootGoesFromItsLastPlace) {
  const NominalMotion nominal = NominalOf(HopScenario());
  EXPECT_EQ(nominal.StepTo(0, 0).norm(), 0.0);
  EXPECT_LT((nominal.StepTo(0, 3) - Eigen::Vector3d(0.09, 0.0, 0.0)).norm(), 1e-12);
}

TEST(NominalMotionTest, StartsAreThoseOfItsContacts) {
  const NominalMotion nominal = NominalOf(TwoFeetScenario());
  for (std::size_t foot = 0; foot < 2; ++foot) {
    ASSERT_EQ(nominal.starts(foot).size(), nominal.contacts(foot).size());
    for (std::size_t i = 0; i < nominal.starts(foot).size(); ++i) {
      EXPECT_EQ(nominal.starts(foot)[i], nominal.contacts(foot)[i].start_tick);
    }
  }
  EXPECT_EQ(nominal.starts(0)[1], 800);
}

TEST(NearestStartTest, IsTheEarlierOfTwoAsNear) {
  const std::vector<Tick> starts{0, 800, 2400};
  EXPECT_EQ(NearestStart(starts, -5), 0u);
  EXPECT_EQ(NearestStart(starts, 400), 0u);
  EXPECT_EQ(NearestStart(starts, 401), 1u);
  EXPECT_EQ(NearestStart(starts, 1599), 1u);
  EXPECT_EQ(NearestStart(starts, 1601), 2u);
  EXPECT_EQ(NearestStart(starts, 1 << 20), 2u);
  EXPECT_THROW(NearestStart({}, 0), ContractViolation);
}

TEST(NominalMotionTest, ScenarioWithoutGaitBreaksTheContract) {
  Scenario scenario = HopScenario();
  scenario.gait.clear();
  EXPECT_THROW(NominalOf(scenario), ContractViolation);
}

}  // namespace
}  // namespace sidestep::nominal_motion_test
