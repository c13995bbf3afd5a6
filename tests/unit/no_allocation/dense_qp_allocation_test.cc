// SPDX-License-Identifier: BSD-3-Clause
// Solve takes no memory, whatever the sizes.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>

#include "controller/wbc/qp/dense_qp.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc::dense_qp_allocation_test {
namespace {

std::int64_t CountDuringSolve(DenseQpSolver& solver, const DenseQpView& problem,
                              const DenseQpSolution* guess) {
  const std::int64_t before = CountAllocations();
  solver.Solve(problem, guess);
  return CountAllocations() - before;
}

TEST(DenseQpAllocationTest, SolveTakesNoMemoryAsSizesComeAndGo) {
  DenseQpSolver solver(RandomQpMaxima());
  const DenseQpSolution* guess = nullptr;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const QpFamily family : kAllQpFamilies) {
      const DenseQpProblem problem = MakeRandomQp(family, seed);
      ASSERT_EQ(CountDuringSolve(solver, problem, guess), 0) << ToString(family) << " " << seed;
      guess = &solver.Solve(problem);
      ASSERT_EQ(guess->status, QpStatus::kSolved);
    }
  }
}

TEST(DenseQpAllocationTest, SolveTakesNoMemoryAboveEigensStackLimit) {
  // 300 x 500 doubles are 1.2 MB; Eigen's products spill to the heap at 128 KiB.
  constexpr int kN = 300, kEqualities = 40, kInequalities = 500;
  SeededNumbers numbers(1);
  DenseQpProblem problem;
  problem.H = RandomPositiveDefinite(numbers, kN, kN, 0.1);
  problem.g = numbers.NormalMatrix(kN, 1);
  problem.A = numbers.NormalMatrix(kEqualities, kN);
  problem.b = Eigen::VectorXd::Zero(kEqualities);
  problem.C = numbers.NormalMatrix(kInequalities, kN);
  problem.lower = Eigen::VectorXd::Constant(kInequalities, -2.0);
  problem.upper = Eigen::VectorXd::Constant(kInequalities, 2.0);
  DenseQpSolver solver({kN, kEqualities, kInequalities});
  EXPECT_EQ(CountDuringSolve(solver, problem, nullptr), 0);
  EXPECT_EQ(solver.Solve(problem).status, QpStatus::kSolved);
}

TEST(DenseQpAllocationTest, HardProblemsTakeNoMemoryEither) {
  DenseQpSolver solver(RandomQpMaxima());
  DenseQpProblem problem = MakeRandomQp(QpFamily::kVelocity, 3);
  DenseQpProblem crossed = problem;
  crossed.lower(0) = crossed.upper(0) + 1.0;
  DenseQpProblem spoilt = problem;
  spoilt.g(0) = std::numeric_limits<double>::quiet_NaN();
  DenseQpProblem endless = problem;
  endless.H.setZero();
  endless.lower.setConstant(-std::numeric_limits<double>::infinity());
  EXPECT_EQ(CountDuringSolve(solver, crossed, nullptr), 0);
  EXPECT_EQ(solver.Solve(crossed).status, QpStatus::kInfeasible);
  EXPECT_EQ(CountDuringSolve(solver, spoilt, nullptr), 0);
  EXPECT_EQ(solver.Solve(spoilt).status, QpStatus::kNumericalError);
  EXPECT_EQ(CountDuringSolve(solver, endless, nullptr), 0);
  EXPECT_EQ(solver.Solve(endless).status, QpStatus::kUnbounded);
}

}  // namespace
}  // namespace sidestep::wbc::dense_qp_allocation_test
