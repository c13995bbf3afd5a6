// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/feasibility.h"

#include <gtest/gtest.h>

#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::feasibility_test {
namespace {

TEST(FeasibilityTest, ConesBandsAndContradictions) {
  Eigen::MatrixX3d A(6, 3);
  A << 1, 1, -0.5, -1, 1, -0.5, -1, -1, -0.5, 1, -1, -0.5, 0, 0, -1, 0, 0, 1;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(6);
  EXPECT_TRUE(HasFeasibleForce(A.topRows(4), b.head(4), 1e-9)) << "a cone's apex is inside";
  b(4) = -80.0;  // At least 80 N.
  b(5) = 100.0;  // At most 100 N.
  EXPECT_TRUE(HasFeasibleForce(A, b, 1e-9));
  b(5) = 80.0;
  EXPECT_TRUE(HasFeasibleForce(A, b, 1e-9)) << "exactly 80 N";
  b(5) = 79.9;
  EXPECT_FALSE(HasFeasibleForce(A, b, 1e-9));
  b << -1, -1, -1, -1, -80, 1e6;  // Inside the cone with a margin.
  EXPECT_TRUE(HasFeasibleForce(A, b, 1e-9));
  b << -200, 0, -200, 0, 0, 100;  // Two opposite faces that leave 400 N between them missing.
  EXPECT_FALSE(HasFeasibleForce(A, b, 1e-9));
  EXPECT_TRUE(HasFeasibleForce(Eigen::MatrixX3d(0, 3), Eigen::VectorXd(0), 1e-9));
}

TEST(FeasibilityTest, TheLeastViolationIsADistance) {
  Eigen::MatrixX3d A(2, 3);
  A << 0, 0, 3, 0, 0, -5;  // z <= 1 and z >= 1.5: the middle misses both by 0.25
  const Eigen::Vector2d b(3.0, -7.5);
  EXPECT_NEAR(LeastForceViolation(A, b, 0.0), 0.25, 1e-9);
  EXPECT_LE(LeastForceViolation(A, Eigen::Vector2d(3.0, -5.0), 1e-9), 1e-9);
}

TEST(FeasibilityTest, SaysWhatContradictsItself) {
  EXPECT_EQ(Infeasibility(ReferenceProblem("icub_nominal_just_landed")), "");
  EXPECT_EQ(Infeasibility(ReferenceProblem("infeasible_inverted_box")),
            "a foot's box has its lower bound above its upper one");
  EXPECT_NE(Infeasibility(ReferenceProblem("infeasible_force_limits")).find("misses one by"),
            std::string::npos);
  CentroidalOcp flying = ReferenceProblem("infeasible_force_limits");
  for (OcpContact& contact : flying.contacts) contact.phases.clear();
  EXPECT_FALSE(IsInfeasible(flying)) << "nobody asks for a force";
}

}  // namespace
}  // namespace sidestep::mpc::feasibility_test
