// SPDX-License-Identifier: BSD-3-Clause
#include "controller/types/friction_pyramid.h"

#include <gtest/gtest.h>

#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::friction_pyramid_test {
namespace {

TEST(FrictionPyramidTest, HoldsWhatItsConeHoldsAtItsCornersAndNeverMore) {
  const auto holds = [A = FrictionPyramid(0.5)](double x, double y, double z) {
    return (A * Eigen::Vector3d(x, y, z)).maxCoeff() <= 1e-12;
  };
  EXPECT_TRUE(holds(0.0, 0.0, 1.0));
  EXPECT_TRUE(holds(0.5, 0.0, 1.0)) << "the cone's own bound along an axis";
  EXPECT_FALSE(holds(0.51, 0.0, 1.0));
  EXPECT_FALSE(holds(0.0, -0.51, 1.0));
  EXPECT_FALSE(holds(0.3, 0.3, 1.0)) << "inside the cone, outside the pyramid";
  EXPECT_FALSE(holds(0.0, 0.0, -1.0)) << "the ground does not pull";
  for (double angle_rad = 0.0; angle_rad < 6.3; angle_rad += 0.1) {
    EXPECT_FALSE(holds(0.501 * std::cos(angle_rad), 0.501 * std::sin(angle_rad), 1.0));
  }
}

TEST(FrictionPyramidTest, FacesGoRoundFromTheOneBetweenXAndY) {
  // Solvers' answers depend on the order in the last bits.
  const Eigen::Matrix<double, 4, 3> A = FrictionPyramid(0.5);
  EXPECT_EQ(A.row(0), Eigen::RowVector3d(1, 1, -0.5));
  EXPECT_EQ(A.row(1), Eigen::RowVector3d(-1, 1, -0.5));
  EXPECT_EQ(A.row(2), Eigen::RowVector3d(-1, -1, -0.5));
  EXPECT_EQ(A.row(3), Eigen::RowVector3d(1, -1, -0.5));
}

TEST(FrictionViolationTest, IsZeroInsideAndTheWorseOfSlidingAndPullingOutside) {
  EXPECT_EQ(FrictionViolation_N({0.1, -0.1, 1.0}, 0.5), 0.0);
  EXPECT_NEAR(FrictionViolation_N({0.5, -0.25, 1.0}, 0.5), 0.25, 1e-15);
  EXPECT_NEAR(FrictionViolation_N({-0.5, 0.25, 1.0}, 0.5), 0.25, 1e-15);
  EXPECT_NEAR(FrictionViolation_N({0.1, 0.0, -2.0}, 0.5), 2.0, 1e-15) << "pulls by 2 N";
  EXPECT_NEAR(FrictionViolation_N({3.0, 0.0, -2.0}, 0.5), 4.0, 1e-15) << "3 N beyond -1 N";
}

TEST(FrictionViolationTest, IsPositiveExactlyWhereAFaceIsViolated) {
  mpc::Numbers numbers(5);
  int num_inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d f_F = numbers.Vector3();
    const bool is_inside = (FrictionPyramid(1.5) * f_F).maxCoeff() <= 0.0;
    EXPECT_EQ(FrictionViolation_N(f_F, 1.5) == 0.0, is_inside) << f_F.transpose();
    num_inside += is_inside ? 1 : 0;
  }
  EXPECT_GT(num_inside, 100);
  EXPECT_LT(num_inside, 900);
}

}  // namespace
}  // namespace sidestep::friction_pyramid_test
