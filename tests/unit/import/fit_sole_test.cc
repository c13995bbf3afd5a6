// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/fit_sole.h"

#include <gtest/gtest.h>

namespace sidestep::importer {
namespace {

using Vector = Eigen::Vector3d;

std::vector<SurfacePoint> Box(const Vector& size, const Vector& middle, const Eigen::Matrix3d& R) {
  std::vector<SurfacePoint> points;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector sign((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                      (corner & 4) != 0 ? 0.5 : -0.5);
    points.push_back({R * (middle + sign.cwiseProduct(size)), 0.0});
  }
  return points;
}

TEST(FitSole, FindsTheBottomOfABox) {
  const Sole sole = FitSole(Box({0.2, 0.1, 0.03}, {0.03, 0.01, -0.05}, Eigen::Matrix3d::Identity()),
                            Vector::UnitX(), Vector::UnitZ());
  EXPECT_NEAR(sole.length_m, 0.2, 1e-12);
  EXPECT_NEAR(sole.width_m, 0.1, 1e-12);
  EXPECT_LT((sole.X_FS.translation() - Vector(0.03, 0.01, -0.065)).norm(), 1e-12);
  EXPECT_TRUE(sole.X_FS.linear().isIdentity(1e-12));
}

TEST(FitSole, StandsOnTheBottomsOfFourBalls) {
  std::vector<SurfacePoint> balls;
  for (const double x : {-0.05, 0.12}) {
    for (const double y : {-0.03, 0.03}) balls.push_back({{x, y, -0.03}, 0.005});
  }
  const Sole sole = FitSole(balls, Vector::UnitX(), Vector::UnitZ());
  EXPECT_NEAR(sole.X_FS.translation().z(), -0.035, 1e-12);
  EXPECT_NEAR(sole.length_m, 0.17, 1e-12);
  EXPECT_NEAR(sole.width_m, 0.06, 1e-12);
}

TEST(FitSole, FollowsAFootFrameWithOtherAxes) {
  Eigen::Matrix3d R;  // the foot's y points down, its z to the front
  R << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  R = Eigen::AngleAxisd(0.5 * M_PI, Vector::UnitX()).toRotationMatrix() * R;
  const Sole sole = FitSole(Box({0.2, 0.1, 0.03}, {0.0, 0.0, -0.05}, R), R * Vector::UnitX(),
                            R * Vector::UnitZ());
  EXPECT_NEAR(sole.length_m, 0.2, 1e-12);
  EXPECT_LT((sole.X_FS.translation() - R * Vector(0, 0, -0.065)).norm(), 1e-12);
  EXPECT_LT((sole.X_FS.linear() - R).norm(), 1e-12);
}

TEST(FitSole, FindsASoleThatIsTiltedAtZero) {
  const double pitch = 0.3;
  const Eigen::Matrix3d R = Eigen::AngleAxisd(pitch, Vector::UnitY()).toRotationMatrix();
  const Sole sole =
      FitSole(Box({0.2, 0.1, 0.03}, {0.03, 0.0, -0.05}, R), Vector::UnitX(), Vector::UnitZ());
  EXPECT_NEAR(sole.tilt_rad, pitch, 0.01);
  EXPECT_NEAR(sole.length_m, 0.2, 0.002);
  EXPECT_NEAR(sole.width_m, 0.1, 0.002);
}

TEST(FitSole, HasNoSizeOnAPointOrAnEdge) {
  const Sole ball = FitSole({{{0, 0, 0}, 0.03}}, Vector::UnitX(), Vector::UnitZ());
  EXPECT_EQ(ball.length_m, 0.0);
  const Sole edge = FitSole({{{0, 0, 0}, 0}, {{0.2, 0, 0}, 0}, {{0.1, 0, 0}, 0}}, Vector::UnitX(),
                            Vector::UnitZ());
  EXPECT_EQ(edge.length_m * edge.width_m, 0.0);
}

}  // namespace
}  // namespace sidestep::importer
