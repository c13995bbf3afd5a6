// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/recovery.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/planner/gait_planner.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::recovery_test {
namespace {

constexpr Tick kHorizon = 1000;
constexpr Tick kEnd = 5000;
constexpr Tick kGrid = 50;
constexpr double kMass_kg = 10.0;

// Soles of 0.2 m x 0.1 m at y = +-0.08.
std::vector<Eigen::Matrix3Xd> Soles() {
  Eigen::Matrix3Xd sole(3, 4);
  sole << 0.1, 0.1, -0.1, -0.1, 0.05, -0.05, -0.05, 0.05, 0.0, 0.0, 0.0, 0.0;
  return {sole, sole};
}

RobotState Standing() {
  RobotState state;
  state.p_WC = {0.0, 0.0, 0.4905};  // w = sqrt(9.81 / 0.4905) = sqrt(20)
  state.feet.resize(2);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    state.feet[foot].p_WF = {0.0, foot == 0 ? 0.08 : -0.08, kSoleHeight_m};
    state.feet[foot].in_contact = true;
  }
  return state;
}

GaitPlanner Planner(bool enabled) {
  const std::vector<GaitParams> stand{Stretch(GaitType::kStand, 0.0)};
  PlannerParams params;
  params.recovery.enabled = enabled;
  GaitPlanner planner(BuildNominalGait(stand, Geometry(2), kEnd, kTick_s), params, kHorizon,
                      kTick_s);
  if (enabled) planner.EnableRecovery({stand, Geometry(2), kEnd, kGrid, kMass_kg, Soles()});
  return planner;
}

RobotState MovingForward(double speed_times_time_constant_m) {
  RobotState state = Standing();
  state.v_WC.x() = speed_times_time_constant_m * std::sqrt(20.0);
  return state;
}

std::size_t PlannedContacts(const ContactPlan& plan) {
  return plan.feet[0].size() + plan.feet[1].size();
}

TEST(RecoveryTest, CapturePointAddsSpeedOverRateAndPushOverStiffness) {
  RobotState state = Standing();
  state.v_WC = {0.2 * std::sqrt(20.0), 0.0, 0.0};
  state.external_wrench.force_N = {0.0, 20.0, 0.0};
  // By hand: 0.2 m along x; 20 N / (10 kg 20 / s^2) = 0.1 m along y.
  const Eigen::Vector2d point = CapturePoint(state, kMass_kg);
  EXPECT_NEAR(point.x(), 0.2, 1e-12);
  EXPECT_NEAR(point.y(), 0.1, 1e-12);
}

TEST(RecoveryTest, DistanceIsZeroBetweenTheFeetAndCountsFromTheHullOutside) {
  const RobotState state = Standing();
  EXPECT_EQ(DistanceFromSoles({0.0, 0.0}, state.feet, Soles()), 0.0);
  EXPECT_EQ(DistanceFromSoles({0.09, 0.12}, state.feet, Soles()), 0.0);
  EXPECT_NEAR(DistanceFromSoles({0.15, 0.0}, state.feet, Soles()), 0.05, 1e-9);
  EXPECT_NEAR(DistanceFromSoles({0.0, -0.2}, state.feet, Soles()), 0.07, 1e-9);
}

TEST(RecoveryTest, RobotThatItsFeetCanHoldGoesOnStanding) {
  GaitPlanner planner = Planner(true);
  const RobotState state = MovingForward(0.05);
  EXPECT_EQ(PlannedContacts(planner.Update(state, 100)), 2u);
}

TEST(RecoveryTest, RobotThatItsFeetCannotHoldStepsTowardsTheCapturePoint) {
  GaitPlanner planner = Planner(true);
  const RobotState state = MovingForward(0.3);
  const ContactPlan& plan = planner.Update(state, 100);
  EXPECT_GT(PlannedContacts(plan), 2u);
  double farthest_m = 0.0;
  for (const auto& contacts : plan.feet) {
    for (const PlannedContact& contact : contacts) {
      farthest_m = std::max(farthest_m, contact.nominal_p_WF.x());
    }
  }
  EXPECT_GT(farthest_m, 0.15);
}

TEST(RecoveryTest, NothingStepsUnlessItIsEnabled) {
  GaitPlanner planner = Planner(false);
  const RobotState state = MovingForward(0.3);
  EXPECT_EQ(PlannedContacts(planner.Update(state, 100)), 2u);
}

TEST(RecoveryTest, StepsBeginOnTheGridOnly) {
  GaitPlanner planner = Planner(true);
  const RobotState state = MovingForward(0.3);
  EXPECT_EQ(PlannedContacts(planner.Update(state, 101)), 2u);
  EXPECT_GT(PlannedContacts(planner.Update(state, 150)), 2u);
}

}  // namespace
}  // namespace sidestep::recovery_test
