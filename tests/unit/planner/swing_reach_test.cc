// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/swing_reach.h"

#include <gtest/gtest.h>

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

PlannedContact Within(ContactSchedule schedule, const Eigen::Vector3d& p_WF, Tick tick) {
  KeepWithinSwing({p_WF}, 1.0, tick, kTick_s, &schedule);
  return schedule.feet[0][0].contact;
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

TEST(SwingReachTest, AStandingFootsNextStepIsFree) {
  const PlannedContact contact = Within(Flight(), {0.0, 0.0, 0.0}, 400);
  EXPECT_EQ(contact.box_lower_m, Eigen::Vector3d(-0.2, -0.1, 0.0));
}

}  // namespace
}  // namespace sidestep::swing_reach_test
