// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/support_area.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace sidestep::dcm::support_area_test {
namespace {

constexpr double kExact = 1e-12;

SupportArea AreaOf(std::initializer_list<Eigen::Vector2d> vertices) {
  SupportArea area;
  for (const Eigen::Vector2d& p_m : vertices) {
    area.Add(p_m, 1.0 / static_cast<double>(vertices.size()));
  }
  return area;
}

SupportArea Sole() { return AreaOf({{0.1, 0.05}, {0.1, -0.05}, {-0.1, -0.05}, {-0.1, 0.05}}); }

Eigen::Vector2d PressureOf(const SupportArea& area) {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < area.size(); ++i) p_m += area.share(i) * area.vertex(i);
  return p_m;
}

TEST(SupportAreaTest, NearestIsThePointItselfInside) {
  const Eigen::Vector2d inside(0.07, -0.04);
  EXPECT_EQ(Sole().Nearest(inside), inside);
}

TEST(SupportAreaTest, NearestIsOnTheEdgeOrTheCornerOutside) {
  EXPECT_NEAR((Sole().Nearest({0.03, 0.2}) - Eigen::Vector2d(0.03, 0.05)).norm(), 0.0, kExact);
  EXPECT_NEAR((Sole().Nearest({0.3, -0.2}) - Eigen::Vector2d(0.1, -0.05)).norm(), 0.0, kExact);
}

TEST(SupportAreaTest, InnerVerticesAndPointsInALineAreNoEdges) {
  SupportArea area = Sole();
  area.Add({0.0, 0.0}, 0.0);
  EXPECT_NEAR((area.Nearest({0.0, 0.2}) - Eigen::Vector2d(0.0, 0.05)).norm(), 0.0, kExact);
  const SupportArea line = AreaOf({{0.0, 0.0}, {0.1, 0.0}, {0.2, 0.0}});
  EXPECT_NEAR((line.Nearest({0.05, 0.1}) - Eigen::Vector2d(0.05, 0.0)).norm(), 0.0, kExact);
}

TEST(SupportAreaTest, SharesPutThePressureWhereItIsAsked) {
  SupportArea area = Sole();
  const Eigen::Vector2d asked(0.04, -0.01);
  area.ShareOut(asked);
  EXPECT_NEAR((PressureOf(area) - asked).norm(), 0.0, kExact);
  EXPECT_NEAR(area.share(0) + area.share(2), area.share(1) + area.share(3), kExact);
}

TEST(SupportAreaTest, SharesAreLikedOnesWhereThoseFit) {
  SupportArea area;
  area.Add({0.0, 0.0}, 0.6);
  area.Add({0.1, 0.0}, 0.4);
  area.ShareOut({0.04, 0.0});
  EXPECT_NEAR(area.share(0), 0.6, kExact);
  EXPECT_NEAR(area.share(1), 0.4, kExact);
}

TEST(SupportAreaTest, NoShareIsNegativeAndTheyAddUp) {
  SupportArea area = Sole();
  area.ShareOut({0.1, 0.05});
  double sum = 0.0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    EXPECT_GE(area.share(i), 0.0);
    sum += area.share(i);
  }
  EXPECT_NEAR(sum, 1.0, kExact);
}

}  // namespace
}  // namespace sidestep::dcm::support_area_test
