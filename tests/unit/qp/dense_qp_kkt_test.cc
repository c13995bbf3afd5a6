// SPDX-License-Identifier: BSD-3-Clause
// Optimality of 5000 random problems, judged without the solver's own residuals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "controller/wbc/qp/dense_qp.h"
#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc::dense_qp_kkt_test {
namespace {

// Sanitizers look for other mistakes than the optimised build, which runs the full number.
#ifdef __SANITIZE_ADDRESS__
constexpr int kProblemsPerFamily = 100;
#else
constexpr int kProblemsPerFamily = 500;
#endif

// The solver promises 1e-9 on its own measure; ours differs from it in rounding only.
constexpr double kTolerance = 1.01e-9;

// Largest relative KKT error, rows and entries measured as DenseQpSolution says.
double KktError(const DenseQpProblem& problem, const DenseQpSolution& solution) {
  const Eigen::VectorXd x = solution.x;
  const Eigen::VectorXd lambda = solution.inequality_multipliers;
  const Eigen::VectorXd curvature = problem.H * x;
  const Eigen::VectorXd equality = problem.A.transpose() * solution.equality_multipliers;
  const Eigen::VectorXd inequality = problem.C.transpose() * lambda;
  double worst = 0.0;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double sum = curvature(j) + problem.g(j) + equality(j) + inequality(j);
    const double size = std::max({std::abs(curvature(j)), std::abs(problem.g(j)),
                                  std::abs(equality(j)), std::abs(inequality(j))});
    worst = std::max(worst, std::abs(sum) / (1.0 + size));
  }
  const Eigen::VectorXd equality_error = problem.A * x - problem.b;
  for (Eigen::Index i = 0; i < problem.b.size(); ++i) {
    worst = std::max(worst, std::abs(equality_error(i)) / (1.0 + std::abs(problem.b(i))));
  }
  const double cost_size = 1.0 + std::abs(x.dot(curvature)) + std::abs(problem.g.dot(x));
  const Eigen::VectorXd values = problem.C * x;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double below = problem.lower(i) - values(i);
    const double above = values(i) - problem.upper(i);
    if (below > 0.0) worst = std::max(worst, below / (1.0 + std::abs(problem.lower(i))));
    if (above > 0.0) worst = std::max(worst, above / (1.0 + std::abs(problem.upper(i))));
    if (lambda(i) > 0.0) worst = std::max(worst, std::abs(lambda(i) * above) / cost_size);
    if (lambda(i) < 0.0) worst = std::max(worst, std::abs(lambda(i) * below) / cost_size);
  }
  return worst;
}

class DenseQpFamilyTest : public testing::TestWithParam<QpFamily> {};

TEST_P(DenseQpFamilyTest, EveryProblemSatisfiesTheKktConditions) {
  DenseQpSolver solver(RandomQpMaxima());
  for (int seed = 0; seed < kProblemsPerFamily; ++seed) {
    const DenseQpProblem problem = MakeRandomQp(GetParam(), static_cast<std::uint64_t>(seed));
    const DenseQpSolution& solution = solver.Solve(problem);
    ASSERT_EQ(solution.status, QpStatus::kSolved) << "seed " << seed;
    ASSERT_LE(KktError(problem, solution), kTolerance) << "seed " << seed;
  }
}

TEST_P(DenseQpFamilyTest, WarmStartedNeighbourSatisfiesTheKktConditionsWithFewerChanges) {
  DenseQpSolver warm_solver(RandomQpMaxima());
  DenseQpSolver cold_solver(RandomQpMaxima());
  int warm_changes = 0;
  int cold_changes = 0;
  for (int seed = 0; seed < kProblemsPerFamily / 5; ++seed) {
    const DenseQpProblem problem = MakeRandomQp(GetParam(), static_cast<std::uint64_t>(seed));
    const DenseQpProblem next = MakeNeighbourQp(problem, static_cast<std::uint64_t>(seed));
    const DenseQpSolution& last = warm_solver.Solve(problem);
    const DenseQpSolution& warm = warm_solver.Solve(next, &last);
    ASSERT_EQ(warm.status, QpStatus::kSolved) << "seed " << seed;
    ASSERT_LE(KktError(next, warm), kTolerance) << "seed " << seed;
    warm_changes += warm.iterations;
    cold_changes += cold_solver.Solve(next).iterations;
  }
  EXPECT_LT(2 * warm_changes, cold_changes);
}

TEST_P(DenseQpFamilyTest, TheSameProblemTwiceGivesTheSameBits) {
  DenseQpSolver used(RandomQpMaxima());
  for (int seed = 0; seed < 20; ++seed) {
    const DenseQpProblem problem = MakeRandomQp(GetParam(), static_cast<std::uint64_t>(seed));
    DenseQpSolver fresh(RandomQpMaxima());
    ASSERT_EQ(used.Solve(problem).x, fresh.Solve(problem).x) << "seed " << seed;
  }
}

TEST_P(DenseQpFamilyTest, ContradictionHiddenInASumOfRowsIsInfeasible) {
  // u'x >= c_u, v'x >= c_v and (u + v)'x <= c_u + c_v - 0.001: any two of them can be met.
  DenseQpDimensions maxima = RandomQpMaxima();
  maxima.inequalities += 3;
  DenseQpSolver solver(maxima);
  for (int seed = 0; seed < kProblemsPerFamily / 5; ++seed) {
    DenseQpProblem problem = MakeRandomQp(GetParam(), static_cast<std::uint64_t>(seed));
    SeededNumbers numbers(static_cast<std::uint64_t>(seed));
    const Eigen::Index n = problem.g.size();
    const Eigen::Index m = problem.lower.size();
    const Eigen::VectorXd middle = solver.Solve(problem).x;
    problem.C.conservativeResize(m + 3, n);
    problem.C.bottomRows(3) = numbers.NormalMatrix(3, n);
    problem.C.row(m + 2) = problem.C.row(m) + problem.C.row(m + 1);
    const Eigen::VectorXd values = problem.C.bottomRows(3) * middle;
    problem.lower.conservativeResize(m + 3);
    problem.upper.conservativeResize(m + 3);
    problem.lower.tail(3) << values(0), values(1), -1e30;
    problem.upper.tail(3) << values(0) + 1.0, values(1) + 1.0, values(2) - 1e-3;
    ASSERT_EQ(solver.Solve(problem).status, QpStatus::kInfeasible) << "seed " << seed;
    problem.upper(m + 2) = values(2) + 1e-6;
    ASSERT_EQ(solver.Solve(problem).status, QpStatus::kSolved) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(AllFamilies, DenseQpFamilyTest, testing::ValuesIn(kAllQpFamilies),
                         [](const auto& param) { return std::string(ToString(param.param)); });

}  // namespace
}  // namespace sidestep::wbc::dense_qp_kkt_test
