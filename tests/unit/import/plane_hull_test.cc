// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/plane_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "models/support/convex_hull.h"

namespace sidestep::importer {
namespace {

TEST(PlaneHull, DropsWhatIsInsideOrOnASide) {
  const auto hull = ConvexHull({{0, 0}, {2, 0}, {1, 0}, {2, 1}, {0, 1}, {1, 0.5}, {0, 0}});
  EXPECT_EQ(hull.size(), 4U);
  EXPECT_NEAR(Area(hull), 2.0, 1e-12);
}

TEST(PlaneHull, HasNoAreaOnALine) {
  EXPECT_NEAR(Area(ConvexHull({{0, 0}, {1, 1}, {2, 2}})), 0.0, 1e-12);
  EXPECT_TRUE(ConvexHull({}).empty());
  EXPECT_EQ(InscribedRectangle(ConvexHull({{0, 0}, {1, 1}})).upper.x(), 0.0);
}

TEST(PlaneHull, ARectangleFillsItself) {
  const Rectangle r = InscribedRectangle(ConvexHull({{-1, 2}, {3, 2}, {3, 5}, {-1, 5}}));
  EXPECT_LT((r.lower - Eigen::Vector2d(-1, 2)).norm(), 1e-12);
  EXPECT_LT((r.upper - Eigen::Vector2d(3, 5)).norm(), 1e-12);
}

TEST(PlaneHull, ASquareIsTheLargestRectangleInACircle) {
  std::vector<Eigen::Vector2d> circle;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180.0;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  const Rectangle r = InscribedRectangle(ConvexHull(circle));
  const Eigen::Vector2d size = r.upper - r.lower;
  EXPECT_NEAR(size.x() * size.y(), 2.0, 0.01);
  for (const double x : {r.lower.x(), r.upper.x()}) {
    for (const double y : {r.lower.y(), r.upper.y()}) EXPECT_LE(std::hypot(x, y), 1.0 + 1e-9);
  }
}

TEST(PlaneHull, ATrapezoidsCornersStayInside) {  // four balls of a foot, the heel narrower
  const Rectangle r = InscribedRectangle(
      ConvexHull({{-0.05, -0.025}, {-0.05, 0.025}, {0.12, 0.03}, {0.12, -0.03}}));
  EXPECT_NEAR(r.upper.x() - r.lower.x(), 0.17, 1e-12);
  EXPECT_NEAR(r.upper.y() - r.lower.y(), 0.05, 1e-12);
}

}  // namespace
}  // namespace sidestep::importer
