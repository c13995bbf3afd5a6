// SPDX-License-Identifier: BSD-3-Clause
// com_sway: how far the CoM reference goes from the path to the foot that stands, in mid-swing.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/planner/contact_schedule.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::com_sway_test {
namespace {

constexpr Tick kEnd = 6000;
constexpr double kHalfWidth_m = 0.08;
constexpr double kRounding = 1e-14;

// The walk's first steps by hand: 0.2 s on both feet, then a foot flies for 0.6 s, the left one
// first. The middle of swing n is at 500 + 800 n ms, that of the stance before it at 100 + 800 n.
constexpr Tick kStep = 800, kMidStance = 100, kMidSwing = 500;
Tick MidSwing(int step) { return kMidSwing + kStep * step; }
Tick MidStance(int step) { return kMidStance + kStep * step; }
double StanceSign(int step) { return step % 2 == 0 ? -1.0 : 1.0; }

NominalGait Gait(const GaitParams& gait, double com_sway, int num_feet = 2) {
  GaitGeometry geometry = Geometry(num_feet);
  geometry.sway.share = com_sway;
  return BuildNominalGait({gait}, geometry, kEnd, kTick_s);
}

GaitParams WalkInPlace() {
  GaitParams walk = Stretch(GaitType::kWalk, 0.0);
  walk.step_length_m = 0.0;
  return walk;
}

ComReference ComAt(const NominalGait& gait, Tick tick) { return NominalComAt(gait, tick, kTick_s); }

class ComSwayTest : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Shares, ComSwayTest, testing::Values(0.1, 0.5, 0.8, 1.0));

TEST_P(ComSwayTest, InMidSwingItIsThatShareOfTheWayToTheFootThatStands) {
  const NominalGait gait = Gait(WalkInPlace(), GetParam());
  for (int step = 0; step < 5; ++step) {
    ASSERT_EQ(FeetDown(gait, MidSwing(step)), 1) << step;
    const ComReference com = ComAt(gait, MidSwing(step));
    EXPECT_NEAR(com.p_WC.y(), StanceSign(step) * GetParam() * kHalfWidth_m, kRounding) << step;
    EXPECT_NEAR(com.v_WC.y(), 0.0, kRounding) << "it turns there";
  }
}

TEST_P(ComSwayTest, OnBothFeetItIsOnThePathAndCrossesItTowardsTheNextStance) {
  const NominalGait gait = Gait(WalkInPlace(), GetParam());
  for (int step = 1; step < 5; ++step) {
    ASSERT_EQ(FeetDown(gait, MidStance(step)), 2) << step;
    const ComReference com = ComAt(gait, MidStance(step));
    EXPECT_NEAR(com.p_WC.y(), 0.0, kRounding);
    // From one foot's side to the other's, twice the sway, in the time of a step.
    EXPECT_NEAR(com.v_WC.y(), StanceSign(step) * 2.0 * GetParam() * kHalfWidth_m / 0.8, kRounding);
  }
}

TEST_P(ComSwayTest, InPlaceNothingMovesAlongThePathNorUp) {
  const NominalGait gait = Gait(WalkInPlace(), GetParam());
  for (Tick tick = 0; tick < 4000; tick += 7) {
    const ComReference com = ComAt(gait, tick);
    ASSERT_EQ(com.p_WC.x(), 0.0) << tick;
    ASSERT_EQ(com.p_WC.z(), kComHeight_m) << tick;
    ASSERT_LE(std::abs(com.p_WC.y()), GetParam() * kHalfWidth_m * (1.0 + 1e-12)) << tick;
  }
}

TEST_P(ComSwayTest, ForwardsItIsHalfwayBetweenTheDoubleSupportsAroundTheSwing) {
  // Steps of 0.1 m: on both feet at 0, 0.05 and 0.15 m, so in the swings at 0.025 and 0.1 m.
  const NominalGait gait = Gait(Stretch(GaitType::kWalk, 0.0), GetParam());
  EXPECT_NEAR(ComAt(gait, MidStance(1)).p_WC.x(), 0.05, kRounding);
  EXPECT_NEAR(ComAt(gait, MidStance(2)).p_WC.x(), 0.15, kRounding);
  EXPECT_NEAR(ComAt(gait, MidSwing(0)).p_WC.x(), 0.025, kRounding);
  EXPECT_NEAR(ComAt(gait, MidSwing(1)).p_WC.x(), 0.1, kRounding);
  EXPECT_NEAR(ComAt(gait, MidSwing(1)).v_WC.x(), 0.1 / 0.8, kRounding);
}

TEST_P(ComSwayTest, AsideItIsMeasuredFromThePathHalfwayThroughTheStep) {
  GaitParams aside = WalkInPlace();
  aside.step_side_m = 0.03;
  const NominalGait gait = Gait(aside, GetParam());
  // Step 0: on the right foot at -0.08 m, the path at 0.015 m. Step 1: on the left foot, landed at
  // 0.03 + 0.08 m, the path at 0.045 m.
  EXPECT_NEAR(ComAt(gait, MidSwing(0)).p_WC.y(), 0.015 + GetParam() * (-0.08 - 0.015), kRounding);
  EXPECT_NEAR(ComAt(gait, MidSwing(1)).p_WC.y(), 0.045 + GetParam() * (0.11 - 0.045), kRounding);
}

TEST_P(ComSwayTest, FeetStandWhereTheyStandWithoutIt) {
  const GaitParams walk = Stretch(GaitType::kWalk, 0.0);
  const NominalGait still = Gait(walk, 0.0), swaying = Gait(walk, GetParam());
  for (std::size_t foot = 0; foot < 2; ++foot) {
    ASSERT_EQ(still.feet[foot].size(), swaying.feet[foot].size());
    for (std::size_t i = 0; i < still.feet[foot].size(); ++i) {
      const PlannedContact& a = still.feet[foot][i].contact;
      const PlannedContact& b = swaying.feet[foot][i].contact;
      EXPECT_EQ(a.start_tick, b.start_tick);
      EXPECT_EQ(a.end_tick, b.end_tick);
      EXPECT_EQ(a.nominal_p_WF, b.nominal_p_WF);
    }
  }
}

TEST_P(ComSwayTest, OnlyAWalkHasIt) {
  for (const GaitType type : {GaitType::kStand, GaitType::kRun, GaitType::kHop}) {
    const int num_feet = type == GaitType::kHop ? 1 : 2;
    const NominalGait still = Gait(Stretch(type, 0.0), 0.0, num_feet);
    const NominalGait gait = Gait(Stretch(type, 0.0), GetParam(), num_feet);
    for (Tick tick = 0; tick < kEnd; tick += 50) {
      ASSERT_EQ(ComAt(gait, tick).p_WC, ComAt(still, tick).p_WC) << tick;
    }
  }
}

TEST(NoComSwayTest, WithoutItTheReferenceNeverLeavesThePath) {
  const NominalGait gait = Gait(Stretch(GaitType::kWalk, 0.0), 0.0);
  for (Tick tick = 0; tick < kEnd; ++tick) {
    ASSERT_EQ(ComAt(gait, tick).p_WC.y(), 0.0) << tick;
    ASSERT_EQ(ComAt(gait, tick).v_WC.y(), 0.0) << tick;
  }
}

}  // namespace
}  // namespace sidestep::com_sway_test
