// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// honest_solution: what an answer of the MPC's back ends says of itself, checked by code that its
// solver does not share.

#include <gtest/gtest.h>

#include <algorithm>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/ipopt/nlp_points.h"
#include "controller/mpc/problem/mpc_solution.h"

namespace sidestep::mpc {

/// Expects the residuals at tolerance, the cost to be that of the point, and the point to keep the
/// constraints (SI, a kg of the robot).
inline void ExpectHonest(const CentroidalOcp& ocp, const MpcSolution& solution) {
  constexpr double kKktTolerance = 1e-6;  // scaled as Ipopt scales
  EXPECT_LE(solution.kkt_error, kKktTolerance);
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  Eigen::VectorXd x;
  PackPoint(ocp, nlp.layout(), solution, &x);
  EXPECT_NEAR(nlp.Cost(x), solution.cost, 1e-9 * solution.cost);
  EXPECT_LT(nlp.ConstraintViolation(x), 1e-8 * std::max(1.0, ocp.mass_kg));
}

}  // namespace sidestep::mpc
