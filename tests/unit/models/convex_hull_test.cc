// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/convex_hull.h"

#include <gtest/gtest.h>

namespace sidestep::convex_hull_test {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(ConvexHullTest, KeepsCornersCounterClockwiseAndDropsTheRest) {
  const Points hull = ConvexHull({{0, 0}, {2, 0}, {1, 0}, {2, 1}, {0, 1}, {1, 0.5}, {2, 1}});
  EXPECT_EQ(hull, (Points{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
}

TEST(ConvexHullTest, OfALineTheEndsAndOfAPointItself) {
  EXPECT_EQ(ConvexHull({{1, 1}, {0, 0}, {2, 2}}), (Points{{0, 0}, {2, 2}}));
  EXPECT_EQ(ConvexHull({{1, 1}, {1, 1}}), (Points{{1, 1}}));
  EXPECT_TRUE(ConvexHull({}).empty());
}

}  // namespace
}  // namespace sidestep::convex_hull_test
