// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_planner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/planner/bounce.h"
#include "models/support/gravity.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::gait_planner_test {
namespace {

constexpr Tick kHorizon = 1000;
// Hopping in place: stance from 500 + 400 k to 750 + 400 k.
constexpr Tick kFirstLanding = 900;
constexpr Tick kHop = 400;
constexpr double kRounding = 1e-12;

PlannerParams Follow(FollowMode mode, double path_return_m = 0.03) {
  PlannerParams params;
  params.follow = mode;
  params.path_return_m = path_return_m;
  return params;
}

GaitPlanner Hopping(const PlannerParams& params, double step_length_m = 0.0) {
  GaitParams hop = Stretch(GaitType::kHop, 0.5);
  hop.step_length_m = step_length_m;
  return {SetupOf({Stretch(GaitType::kStand, 0.0), hop}, 1), params, kHorizon};
}

/// A robot where the hopper in place should be, its foot in the air.
RobotState OnPath() {
  RobotState state;
  state.p_WC = {0.0, 0.0, kComHeight_m};
  state.feet.resize(1);
  return state;
}

/// As OnPath, pushed off; its capture point is off by Offset().
RobotState OffPath() {
  RobotState state = OnPath();
  state.p_WC += Eigen::Vector3d(0.10, -0.04, 0.05);
  state.v_WC = {0.3, 0.1, -1.0};
  return state;
}

Eigen::Vector3d Offset() {
  const double time_constant_s = std::sqrt(kComHeight_m / 9.81);
  return {0.10 + 0.3 * time_constant_s, -0.04 + 0.1 * time_constant_s, 0.0};
}

TEST(GaitPlannerTest, PlanHoldsWhatEndsAfterNowAndBeginsWithinTheHorizon) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kPath));
  for (Tick tick = 0; tick < 6000; tick += 10) {
    const auto& contacts = planner.Update(OnPath(), tick).feet[0];
    ASSERT_FALSE(contacts.empty());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      EXPECT_GT(contacts[i].end_tick, tick);
      EXPECT_LE(contacts[i].start_tick, tick + kHorizon);
      if (i > 0) {
        EXPECT_EQ(contacts[i].index, contacts[i - 1].index + 1) << "none is left out";
      }
    }
    EXPECT_GT(contacts.back().start_tick + kHop, tick + kHorizon) << "the next is beyond";
  }
}

TEST(GaitPlannerTest, ContactChangesToComeAreOnTheGridOfThePlan) {
  constexpr Tick kStep =
      50;  // All times of this gait are multiples of it, in ticks; its start not.
  GaitParams hop = Stretch(GaitType::kHop, 0.513);
  GaitPlanner planner(SetupOf({Stretch(GaitType::kStand, 0.0), hop}, 1), Follow(FollowMode::kPath),
                      kHorizon);
  for (Tick tick = 520; tick < 3000; tick += 10) {
    const ContactPlan& plan = planner.Update(OnPath(), tick);
    for (const PlannedContact& contact : plan.feet[0]) {
      if (contact.start_tick > tick) {
        EXPECT_EQ((contact.start_tick - plan.grid_tick) % kStep, 0) << tick;
      }
      if (contact.end_is_known) {
        EXPECT_EQ((contact.end_tick - plan.grid_tick) % kStep, 0) << tick;
      }
    }
  }
}

TEST(GaitPlannerTest, FootInTheAirBeyondTheHorizonStillHasItsNextContact) {
  GaitParams hop = Stretch(GaitType::kHop, 0.0);
  hop.flight_s = 2.0;
  GaitPlanner planner(SetupOf({hop}, 1), Follow(FollowMode::kPath), 100);
  const auto& contacts = planner.Update(OnPath(), 300).feet[0];
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].start_tick, 2250);
}

TEST(GaitPlannerTest, UnderFollowPathNothingShiftsWhateverHappens) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kPath), 0.1);
  for (Tick tick = 0; tick < 5000; tick += 10) {
    for (const PlannedContact& contact : planner.Update(OffPath(), tick).feet[0]) {
      EXPECT_LT(
          (contact.nominal_p_WF - Eigen::Vector3d(0.1 * contact.index, 0.0, kSoleHeight_m)).norm(),
          kRounding);
    }
  }
}

TEST(GaitPlannerTest, RobotOnItsPathShiftsNothing) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint));
  for (Tick tick = 0; tick < 5000; tick += 10) {
    for (const PlannedContact& contact : planner.Update(OnPath(), tick).feet[0]) {
      EXPECT_LT(contact.nominal_p_WF.head<2>().norm(), kRounding);
    }
  }
}

TEST(GaitPlannerTest, AfterALandingStepsFollowTheCapturePointAndDriftBack) {
  constexpr double kReturn_m = 0.03;
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint, kReturn_m));
  planner.Update(OnPath(), kFirstLanding - 10);
  const auto& contacts = planner.Update(OffPath(), kFirstLanding).feet[0];
  ASSERT_EQ(contacts.size(), 3U);
  const double distance_m = Offset().norm();
  EXPECT_LT(contacts[0].nominal_p_WF.head<2>().norm(), kRounding) << "it has landed already";
  for (std::size_t i = 1; i < contacts.size(); ++i) {
    const double left = 1.0 - kReturn_m * static_cast<double>(i) / distance_m;
    const Eigen::Vector3d expected = left * Offset() + Eigen::Vector3d(0.0, 0.0, kSoleHeight_m);
    EXPECT_LT((contacts[i].nominal_p_WF - expected).norm(), kRounding) << i;
  }
}

TEST(GaitPlannerTest, DriftBackIsAtMostPathReturnAStepAndEndsOnThePath) {
  constexpr double kReturn_m = 0.05;
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint, kReturn_m));
  planner.Update(OffPath(), kFirstLanding);
  Eigen::Vector3d last = Offset();
  // The robot does as planned: its capture point is where the nominal step put it.
  for (int step = 1; step < 8; ++step) {
    const Tick landing = kFirstLanding + step * kHop;
    const Eigen::Vector3d nominal = planner.Update(OnPath(), landing - 1).feet[0][0].nominal_p_WF;
    EXPECT_LT((nominal - last).head<2>().norm(), kReturn_m + kRounding) << step;
    RobotState state = OnPath();
    state.p_WC.head<2>() += nominal.head<2>();
    planner.Update(state, landing);
    last = nominal;
  }
  EXPECT_LT(last.head<2>().norm(), kRounding) << "back after 0.19 m / 0.05 m = 4 steps";
}

TEST(GaitPlannerTest, BetweenLandingsTheShiftStays) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint));
  planner.Update(OffPath(), kFirstLanding);
  const Eigen::Vector3d next = planner.plan().feet[0][1].nominal_p_WF;
  for (Tick tick = kFirstLanding + 1; tick < kFirstLanding + kHop; ++tick) {
    RobotState wild = OffPath();
    wild.p_WC.x() += static_cast<double>(tick - kFirstLanding);
    for (const PlannedContact& contact : planner.Update(wild, tick).feet[0]) {
      if (contact.start_tick == kFirstLanding + kHop) {
        ASSERT_LT((contact.nominal_p_WF - next).norm(), kRounding) << tick;
      }
    }
  }
}

TEST(GaitPlannerTest, UndecidedStepsAreAdjustedToTheirShiftedNominalPlace) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint));
  for (const PlannedContact& contact : planner.Update(OffPath(), kFirstLanding).feet[0]) {
    EXPECT_LT((contact.adjusted_p_WF - contact.nominal_p_WF).norm(), kRounding) << contact.index;
  }
}

TEST(GaitPlannerTest, UndecidedStepThatLandsUnfeltStaysWhereItWasWanted) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint));
  planner.Update(OffPath(), kFirstLanding);
  const Tick next_landing = kFirstLanding + kHop;
  const Eigen::Vector3d wanted =
      planner.Update(OnPath(), next_landing - 1).feet[0][0].adjusted_p_WF;
  const PlannedContact landed = planner.Update(OnPath(), next_landing).feet[0][0];
  EXPECT_EQ(landed.start_tick, next_landing);
  EXPECT_LT((landed.adjusted_p_WF - wanted).norm(), kRounding);
  EXPECT_LT((landed.nominal_p_WF - wanted).norm(), kRounding);
}

TEST(GaitPlannerTest, AdjustedFootholdStaysUntilTheNextDecision) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint));
  const Eigen::Vector3d decided(0.07, -0.02, kSoleHeight_m);
  planner.Update(OnPath(), 100);
  planner.AdoptFootholds({{0, 1, decided}});
  for (Tick tick = 100; tick < kFirstLanding; tick += 10) {
    for (const PlannedContact& contact : planner.Update(OffPath(), tick).feet[0]) {
      if (contact.index == 1) {
        EXPECT_EQ(contact.adjusted_p_WF, decided);
        EXPECT_LT(contact.nominal_p_WF.head<2>().norm(), kRounding);
      }
    }
  }
  // It lands unseen by the sensors: still the decided place.
  EXPECT_EQ(planner.Update(OnPath(), kFirstLanding).feet[0][0].adjusted_p_WF, decided);
  const Eigen::Vector3d changed = decided + Eigen::Vector3d(0.01, 0.0, 0.0);
  planner.AdoptFootholds({{0, 2, changed}});
  EXPECT_EQ(planner.Update(OnPath(), kFirstLanding + 1).feet[0][1].adjusted_p_WF, changed);
}

TEST(GaitPlannerTest, ContactThatHasBegunIsWhereTheBeliefSeesItsFoot) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kPath));
  RobotState state = OnPath();
  state.feet[0].p_WF = {0.05, 0.03, 0.016};
  state.feet[0].in_contact = false;
  EXPECT_LT(planner.Update(state, kFirstLanding).feet[0][0].adjusted_p_WF.head<2>().norm(),
            kRounding)
      << "not on the ground yet";
  state.feet[0].in_contact = true;
  EXPECT_EQ(planner.Update(state, kFirstLanding + 1).feet[0][0].adjusted_p_WF, state.feet[0].p_WF);
  state.feet[0].in_contact = false;
  state.feet[0].p_WF.setConstant(9.0);
  EXPECT_LT(planner.Update(state, kFirstLanding + 2).feet[0][0].adjusted_p_WF.norm(), 0.1)
      << "the last place felt";
}

TEST(GaitPlannerTest, ReferenceIsSmoothBetweenLandings) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint), 0.1);
  RobotState state = OffPath();
  planner.Update(state, kFirstLanding);
  // From the current landing to the end of the horizon nothing is updated: one shift.
  for (Tick tick = kFirstLanding; tick < kFirstLanding + kHorizon; ++tick) {
    const ComReference now = planner.ReferenceAt(tick);
    const ComReference next = planner.ReferenceAt(tick + 1);
    // 0.2 m a step of 0.4 s: accelerations below 10 m/s^2 along the floor, jerks below 500 m/s^3.
    const Eigen::Vector3d step = next.p_WC - now.p_WC - kTick_s * now.v_WC;
    ASSERT_LT(step.head<2>().norm(), 0.5 * 10.0 * kTick_s * kTick_s) << tick;
    ASSERT_LT(std::abs(step.z()), 0.5 * 1.25 * kGravity_mps2 * kTick_s * kTick_s) << tick;
    ASSERT_LT((next.v_WC - now.v_WC - kTick_s * now.a_WC).norm(), 0.5 * 500.0 * kTick_s * kTick_s)
        << tick;
  }
}

TEST(GaitPlannerTest, ReferencePassesOverTheShiftedFootholds) {
  GaitPlanner planner = Hopping(Follow(FollowMode::kCapturePoint));
  const auto& contacts = planner.Update(OffPath(), kFirstLanding).feet[0];
  const Tick mid_stance = contacts[1].start_tick + 125;
  const ComReference reference = planner.ReferenceAt(mid_stance);
  EXPECT_LT((reference.p_WC - contacts[1].nominal_p_WF).head<2>().norm(), kRounding);
  const Bounce bounce = BounceOf(Stretch(GaitType::kHop, 0.0));
  EXPECT_NEAR(reference.p_WC.z(), kComHeight_m - bounce.depth_m, kRounding);
}

TEST(GaitPlannerTest, StandingReferenceRests) {
  const GaitPlanner planner = Hopping(Follow(FollowMode::kPath), 0.1);
  for (const Tick tick : {0, 1, 250, 499}) {
    const ComReference reference = planner.ReferenceAt(tick);
    EXPECT_LT((reference.p_WC - Eigen::Vector3d(0.0, 0.0, kComHeight_m)).norm(), kRounding);
    EXPECT_LT(reference.v_WC.norm(), kRounding);
  }
}

}  // namespace
}  // namespace sidestep::gait_planner_test
