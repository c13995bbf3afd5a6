// SPDX-License-Identifier: BSD-3-Clause
// Slabs that cover what the patches say, once.
#include "sim/world/ground.h"

#include <gtest/gtest.h>

#include <random>

namespace sidestep::ground_test {
namespace {

const std::vector<GroundPatch> kHoleOnTheLeft{{1.0, 1.25, 0.0, 2.0, -0.02}};
const std::vector<GroundPatch> kStepAndHole{{1.0, 2.0, -1.0, 1.0, 0.03},
                                            {2.0, 3.0, 0.0, 2.0, -0.1}};

bool Covers(const GroundSlab& slab, const Eigen::Vector2d& place_W) {
  return slab.from_x_m < place_W.x() && place_W.x() < slab.to_x_m && slab.from_y_m < place_W.y() &&
         place_W.y() < slab.to_y_m;
}

TEST(GroundTest, LevelGroundHasNoSlabs) {
  EXPECT_TRUE(GroundSlabs({}).empty());
  EXPECT_EQ(LowestGround_m({}), 0.0);
  EXPECT_EQ(GroundHeight_m({}, {3.0, 4.0}), 0.0);
}

TEST(GroundTest, AStepIsOneSlabOnThePlane) {
  const std::vector<GroundPatch> step{{1.0, 1.25, -1.0, 2.0, 0.02}};
  ASSERT_EQ(GroundSlabs(step).size(), 1U);
  const GroundSlab slab = GroundSlabs(step)[0];
  EXPECT_EQ(slab.from_x_m, 1.0);
  EXPECT_EQ(slab.to_x_m, 1.25);
  EXPECT_EQ(slab.from_y_m, -1.0);
  EXPECT_EQ(slab.to_y_m, 2.0);
  EXPECT_EQ(slab.height_m, 0.02);
  EXPECT_EQ(LowestGround_m(step), 0.0);
}

TEST(GroundTest, AHoleIsWhatTheSlabsLeaveOut) {
  EXPECT_EQ(LowestGround_m(kHoleOnTheLeft), -0.02);
  EXPECT_EQ(GroundSlabs(kHoleOnTheLeft).size(), 4U) << "before, behind, and both its sides";
}

TEST(GroundTest, AnEdgeBelongsToTheHigherSide) {
  EXPECT_EQ(GroundHeight_m(kHoleOnTheLeft, {1.0, 1.0}), 0.0);
  EXPECT_EQ(GroundHeight_m(kHoleOnTheLeft, {1.1, 1.0}), -0.02);
  EXPECT_EQ(GroundHeight_m(kHoleOnTheLeft, {1.1, -0.1}), 0.0);
  EXPECT_EQ(GroundHeight_m(kStepAndHole, {2.0, 0.5}), 0.03);
  EXPECT_EQ(GroundHeight_m(kStepAndHole, {1.0, 0.5}), 0.03);
}

TEST(GroundTest, TheSeamOfTwoHolesIsAsDeepAsTheShallowerOne) {
  const std::vector<GroundPatch> holes{
      {1.0, 2.0, -1.0, 1.0, -0.03}, {2.0, 3.0, -1.0, 1.0, -0.02}, {2.0, 3.0, 1.0, 2.0, -0.04}};
  EXPECT_EQ(GroundHeight_m(holes, {2.0, 0.0}), -0.02);
  EXPECT_EQ(GroundHeight_m(holes, {2.5, 1.0}), -0.02);
  EXPECT_EQ(GroundHeight_m(holes, {2.0, 1.0}), 0.0) << "level ground meets their corner";
  EXPECT_EQ(GroundHeight_m(holes, {3.0, 0.0}), 0.0);
}

TEST(GroundTest, EveryPlaceAboveTheLowestLiesUnderOneSlabOfItsHeight) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> near_m(-4.0, 4.0);
  for (const auto& ground : {kHoleOnTheLeft, kStepAndHole}) {
    const std::vector<GroundSlab> slabs = GroundSlabs(ground);
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector2d place_W(near_m(random), near_m(random));
      const double height_m = GroundHeight_m(ground, place_W);
      int covering = 0;
      for (const GroundSlab& slab : slabs) {
        if (!Covers(slab, place_W)) continue;
        EXPECT_EQ(slab.height_m, height_m);
        ++covering;
      }
      EXPECT_EQ(covering, height_m > LowestGround_m(ground) ? 1 : 0) << place_W.transpose();
    }
  }
}

}  // namespace
}  // namespace sidestep::ground_test
