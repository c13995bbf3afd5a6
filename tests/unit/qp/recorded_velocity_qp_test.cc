// SPDX-License-Identifier: BSD-3-Clause
// The problems that the inverse kinematics really poses, of iCub3 under sane and wild targets,
// solved by Ipopt too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/wbc/inverse_kinematics.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/ipopt_dense_qp.h"
#include "tests/support/wild_targets.h"

namespace sidestep::wbc::recorded_velocity_qp_test {

namespace {

// As in dense_qp_ipopt_test: Ipopt's duality gap is about (number of bounds) * tolerance * scaling,
// and a point errs by about sqrt(cost error / smallest curvature).
constexpr double kIpoptTolerance = 1e-10;
constexpr double kCostTolerance = 1e-7;
constexpr double kPointTolerance = 1e-4;

#ifdef __SANITIZE_ADDRESS__
constexpr int kProblems = 50;
#else
constexpr int kProblems = 2000;
#endif

double Cost(const DenseQpProblem& problem, const Eigen::VectorXd& x) {
  return 0.5 * x.dot(problem.H * x) + problem.g.dot(x);
}

/// The problem of the last solve, which has no CoM rows if those had to give way.
DenseQpProblem Recorded(const InverseKinematics& inverse_kinematics) {
  const DenseQpView view = inverse_kinematics.problem();
  return {view.H, view.g, view.A, view.b, view.C, view.lower, view.upper};
}

TEST(RecordedVelocityQpTest, CostAndPointAgreeWithIpopt) {
  IcubStance stance;
  InverseKinematics inverse_kinematics(stance.robot, InverseKinematicsParams{}, kStanceTick_s);
  WildTargets targets(7, &stance);
  DenseQpSolver solver({29, 15, 23});
  ActuatorCommand command;
  int compared = 0, infeasible = 0, bounded = 0, soft = 0;
  double worst_cost = 0.0, worst_point = 0.0;
  for (int number = 0; number < kProblems; ++number) {
    targets.Next();
    const bool is_exact =
        inverse_kinematics.Solve(stance.state, stance.body, stance.com, stance.feet, &command).ok;
    const DenseQpProblem problem = Recorded(inverse_kinematics);
    const DenseQpSolution& solution = solver.Solve(problem);
    const IpoptQpResult reference = SolveWithIpopt(problem, kIpoptTolerance);
    if (solution.status == QpStatus::kInfeasible) {
      EXPECT_FALSE(reference.is_solved) << "problem " << number << " is feasible";
      ++infeasible;
      continue;
    }
    ASSERT_EQ(solution.status, QpStatus::kSolved) << "problem " << number;
    soft += is_exact ? 0 : 1;
    bounded += solution.inequality_multipliers.cwiseAbs().maxCoeff() > 1e-6 ? 1 : 0;
    if (!reference.is_solved) continue;  // counted below
    ++compared;
    const double expected = Cost(problem, reference.x);
    const double cost_error =
        std::abs(Cost(problem, solution.x) - expected) / (1.0 + std::abs(expected));
    const double point_error =
        (Eigen::VectorXd(solution.x) - reference.x).norm() / (1.0 + reference.x.norm());
    EXPECT_LE(cost_error, kCostTolerance) << "problem " << number;
    EXPECT_LE(point_error, kPointTolerance) << "problem " << number;
    worst_cost = std::max(worst_cost, cost_error);
    worst_point = std::max(worst_point, point_error);
  }
  RecordProperty("compared", compared);
  RecordProperty("infeasible", infeasible);
  RecordProperty("worst_cost_error_e12", static_cast<int>(1e12 * worst_cost));
  RecordProperty("worst_point_error_e12", static_cast<int>(1e12 * worst_point));
  EXPECT_GE(compared, (kProblems - infeasible) * 9 / 10) << "Ipopt gave up too often";
  EXPECT_GT(compared, kProblems / 2);
  EXPECT_GT(bounded, kProblems / 10) << "joints at their limits";
  EXPECT_GT(soft, 0) << "the CoM gave way";
}

}  // namespace
}  // namespace sidestep::wbc::recorded_velocity_qp_test
