// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/sole_outline.h"

#include <gtest/gtest.h>

namespace sidestep::sole_outline_test {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using plot::ConvexHull;

TEST(SoleOutlineTest, ARectanglesCornersGoAroundItWhateverTheirOrder) {
  const Points expected{{-1, -1}, {2, -1}, {2, 1}, {-1, 1}};
  EXPECT_EQ(ConvexHull({{2, 1}, {-1, -1}, {-1, 1}, {2, -1}}), expected);
}

TEST(SoleOutlineTest, WhatLiesWithinOrOnAnEdgeIsNoCorner) {
  const Points expected{{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(ConvexHull({{1, 1}, {4, 0}, {2, 0}, {0, 4}, {2, 2}, {0, 0}, {0, 0}}), expected);
}

TEST(SoleOutlineTest, PointsAndLinesStayWhatTheyAre) {
  EXPECT_TRUE(ConvexHull({}).empty());
  EXPECT_EQ(ConvexHull({{1, 2}, {1, 2}}), (Points{{1, 2}}));
  EXPECT_EQ(ConvexHull({{3, 3}, {1, 1}, {2, 2}}), (Points{{1, 1}, {3, 3}}));
}

}  // namespace
}  // namespace sidestep::sole_outline_test
