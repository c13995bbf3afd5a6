// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/swing_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/types/quintic.h"

namespace sidestep::swing_reach_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kRounding = 1e-12;

// One foot that is due at tick 400, nominally at (0.3, 0.1), within 0.2 m ahead and 0.1 m aside.
ContactSchedule Flight() {
  NominalContact next;
  next.contact.start_tick = 400;
  next.contact.end_tick = 900;
  next.contact.nominal_p_WF = {0.3, 0.1, 0.0};
  next.contact.box_lower_m = {-0.2, -0.1, 0.0};
  next.contact.box_upper_m = {0.2, 0.1, 0.0};
  return {{{next}}, {}};
}

constexpr SwingLimits kSpeed{1.0, 0.0};          // 1 m/s
constexpr SwingLimits kAcceleration{0.0, 30.0};  // 30 m/s^2

PlannedContact Within(ContactSchedule schedule, const MovingFoot& foot, Tick tick,
                      const SwingLimits& limits) {
  KeepWithinSwing({foot}, limits, tick, kTick_s, &schedule);
  return schedule.feet[0].back().contact;
}

PlannedContact Within(const ContactSchedule& schedule, const Eigen::Vector3d& p_WF, Tick tick) {
  return Within(schedule, {p_WF}, tick, kSpeed);
}

TEST(SwingReachTest, FarFromTheLandingTheBoxIsTheBounds) {
  const PlannedContact contact = Within(Flight(), {0.3, 0.1, 0.03}, 0);
  EXPECT_EQ(contact.box_lower_m, Eigen::Vector3d(-0.2, -0.1, 0.0));
  EXPECT_EQ(contact.box_upper_m, Eigen::Vector3d(0.2, 0.1, 0.0));
}

TEST(SwingReachTest, NearTheLandingTheFootGoesWhereItsSpeedTakesIt) {
  // 50 ms are 5 cm about (0.25, 0.12).
  const PlannedContact contact = Within(Flight(), {0.25, 0.12, 0.03}, 350);
  EXPECT_LT((contact.box_lower_m - Eigen::Vector3d(-0.1, -0.03, 0.0)).norm(), kRounding);
  EXPECT_LT((contact.box_upper_m - Eigen::Vector3d(0.0, 0.07, 0.0)).norm(), kRounding);
}

TEST(SwingReachTest, AFootThatCannotReachTheBoxGoesToItsNearestPlace) {
  const PlannedContact contact = Within(Flight(), {0.0, 0.3, 0.03}, 350);
  EXPECT_LT((contact.box_lower_m - Eigen::Vector3d(-0.2, 0.1, 0.0)).norm(), kRounding);
  EXPECT_LT((contact.box_upper_m - Eigen::Vector3d(-0.2, 0.1, 0.0)).norm(), kRounding);
}

TEST(SwingReachTest, BoxesAreInTheContactsAxes) {
  ContactSchedule schedule = Flight();
  schedule.feet[0][0].contact.R_WF << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // faces left
  // 4 cm ahead in W is 4 cm to its right.
  const PlannedContact contact = Within(schedule, {0.34, 0.1, 0.03}, 390);
  EXPECT_LT((contact.box_lower_m - Eigen::Vector3d(-0.01, -0.05, 0.0)).norm(), kRounding);
  EXPECT_LT((contact.box_upper_m - Eigen::Vector3d(0.01, -0.03, 0.0)).norm(), kRounding);
}

TEST(SwingReachTest, WhereAFootStandsStaysAsItIs) {
  const PlannedContact contact = Within(Flight(), {0.0, 0.0, 0.0}, 400);
  EXPECT_EQ(contact.box_lower_m, Eigen::Vector3d(-0.2, -0.1, 0.0));
}

TEST(SwingReachTest, WithoutLimitsTheBoxIsTheBounds) {
  const PlannedContact contact = Within(Flight(), {{-5.0, 2.0, 0.0}, {9.0, 9.0, 0.0}}, 390, {});
  EXPECT_EQ(contact.box_lower_m, Eigen::Vector3d(-0.2, -0.1, 0.0));
  EXPECT_EQ(contact.box_upper_m, Eigen::Vector3d(0.2, 0.1, 0.0));
}

// The furthest place is one that a quintic from rest reaches with that acceleration at its peak.
TEST(SwingReachTest, AFootAtRestGetsAsFarAsItsAccelerationLets) {
  const double time_s = 0.1;
  const PlannedContact contact = Within(Flight(), {{0.3, 0.1, 0.0}}, 300, kAcceleration);
  const Quintic way({}, {contact.box_upper_m.x(), 0.0, 0.0}, time_s);
  double peak_mps2 = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    peak_mps2 = std::max(peak_mps2, std::abs(way.At(1e-3 * i * time_s).acceleration));
  }
  EXPECT_NEAR(peak_mps2, kAcceleration.acceleration_mps2, 1e-3);
  EXPECT_LT((contact.box_lower_m + contact.box_upper_m).norm(), kRounding) << "to either side";
}

// What a quintic still has to go it reaches at every moment of its way, but for a tenth at the
// begin of it, which it takes to get going.
TEST(SwingReachTest, OnItsWayAFootKeepsItsTarget) {
  ContactSchedule schedule = Flight();
  schedule.feet[0][0].contact.nominal_p_WF = {0.0, 0.1, 0.0};
  const double target_m = 0.91 * kAcceleration.ReachIn(0.15);
  const Quintic way({}, {target_m, 0.0, 0.0}, 0.15);
  for (Tick tick = 250; tick < 400; ++tick) {
    const QuinticState at = way.At(SecondsAt(tick - 250, kTick_s));
    const MovingFoot foot{{at.position, 0.1, 0.0}, {at.velocity, 0.0, 0.0}};
    const PlannedContact contact = Within(schedule, foot, tick, kAcceleration);
    EXPECT_LE(contact.box_lower_m.x(), target_m + 1e-6) << tick;
    EXPECT_GE(contact.box_upper_m.x(), target_m - 1e-6) << tick;
  }
}

TEST(SwingReachTest, AStandingFootsNextStepHasItsWholeSwing) {
  ContactSchedule schedule = Flight();
  NominalContact stands;
  stands.contact.start_tick = -500;
  stands.contact.end_tick = 350;  // 50 ms in the air
  schedule.feet[0].insert(schedule.feet[0].begin(), stands);
  const PlannedContact contact = Within(schedule, {{0.3, 0.1, 0.0}}, 100, kSpeed);
  EXPECT_LT((contact.box_upper_m - Eigen::Vector3d(0.05, 0.05, 0.0)).norm(), kRounding);
}

}  // namespace
}  // namespace sidestep::swing_reach_test
