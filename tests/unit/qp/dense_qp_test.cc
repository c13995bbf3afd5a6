// SPDX-License-Identifier: BSD-3-Clause
// Problems small enough to be worked by hand, and every way in which a problem can be hard.
#include "controller/wbc/qp/dense_qp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "models/support/require.h"

namespace sidestep::wbc::dense_qp_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Answers worked by hand have few digits; the solver's tolerance is 1e-9.
constexpr double kNear = 1e-9;

DenseQpProblem Unconstrained(const Eigen::MatrixXd& H, const Eigen::VectorXd& g) {
  const Eigen::Index n = g.size();
  return {H,
          g,
          Eigen::MatrixXd(0, n),
          Eigen::VectorXd(0),
          Eigen::MatrixXd(0, n),
          Eigen::VectorXd(0),
          Eigen::VectorXd(0)};
}

void AddInequality(DenseQpProblem& problem, const Eigen::VectorXd& row, double lower,
                   double upper) {
  const Eigen::Index m = problem.lower.size();
  problem.C.conservativeResize(m + 1, row.size());
  problem.C.row(m) = row.transpose();
  problem.lower.conservativeResize(m + 1);
  problem.upper.conservativeResize(m + 1);
  problem.lower(m) = lower;
  problem.upper(m) = upper;
}

void AddEquality(DenseQpProblem& problem, const Eigen::VectorXd& row, double value) {
  const Eigen::Index m = problem.b.size();
  problem.A.conservativeResize(m + 1, row.size());
  problem.A.row(m) = row.transpose();
  problem.b.conservativeResize(m + 1);
  problem.b(m) = value;
}

// 1/2 |x - (3, -4)|^2.
DenseQpProblem DistanceToPoint() {
  return Unconstrained(Eigen::Matrix2d::Identity(), Eigen::Vector2d(-3.0, 4.0));
}

DenseQpSolution SolveOnce(const DenseQpProblem& problem) {
  DenseQpSolver solver({4, 4, 8});
  return solver.Solve(problem);
}

TEST(DenseQpTest, MultiplierSignsMatchTheWorkedExample) {
  // Nearest point to (5, -4, 5) with x1 <= 1, x2 >= -2, x1 + x3 = 4: x = (1, -2, 3).
  // H x + g = (-4, 2, -2). Third row: -2 + nu = 0, nu = 2. First: -4 + nu + lambda_1 = 0,
  // lambda_1 = 2 (upper, positive). Second: 2 + lambda_2 = 0, lambda_2 = -2 (lower, negative).
  DenseQpProblem problem =
      Unconstrained(Eigen::Matrix3d::Identity(), Eigen::Vector3d(-5.0, 4.0, -5.0));
  AddEquality(problem, Eigen::Vector3d(1, 0, 1), 4.0);
  AddInequality(problem, Eigen::Vector3d(1, 0, 0), -kInfinity, 1.0);
  AddInequality(problem, Eigen::Vector3d(0, 1, 0), -2.0, 10.0);
  const DenseQpSolution solution = SolveOnce(problem);
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector3d(1, -2, 3)).norm(), 0.0, kNear);
  EXPECT_NEAR(solution.equality_multipliers(0), 2.0, kNear);
  EXPECT_NEAR(solution.inequality_multipliers(0), 2.0, kNear);
  EXPECT_NEAR(solution.inequality_multipliers(1), -2.0, kNear);
}

TEST(DenseQpTest, UnconstrainedOptimumIsTheTarget) {
  const DenseQpSolution solution = SolveOnce(DistanceToPoint());
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector2d(3, -4)).norm(), 0.0, kNear);
}

TEST(DenseQpTest, EqualBoundsActAsAnEqualityWithItsMultiplier) {
  // x1 pinned to 1: H x + g = (-2, 0), so lambda = 2; pinned to 7: lambda = -4.
  for (const double pin : {1.0, 7.0}) {
    DenseQpProblem problem = DistanceToPoint();
    AddInequality(problem, Eigen::Vector2d(1, 0), pin, pin);
    const DenseQpSolution solution = SolveOnce(problem);
    ASSERT_EQ(solution.status, QpStatus::kSolved);
    EXPECT_NEAR(solution.x(0), pin, kNear);
    EXPECT_NEAR(solution.inequality_multipliers(0), 3.0 - pin, kNear);
  }
}

TEST(DenseQpTest, DependentEqualitiesThatAgreeAreSolved) {
  DenseQpProblem problem = DistanceToPoint();
  AddEquality(problem, Eigen::Vector2d(1, 1), 2.0);
  AddEquality(problem, Eigen::Vector2d(-3, -3), -6.0);
  AddEquality(problem, Eigen::Vector2d(0, 0), 0.0);
  AddEquality(problem, Eigen::Vector2d(1, 1), 2.0);
  const DenseQpSolution solution = SolveOnce(problem);
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector2d(4.5, -2.5)).norm(), 0.0, kNear);
}

TEST(DenseQpTest, EqualitiesThatFixEveryVariableLeaveTheirPoint) {
  DenseQpProblem problem = DistanceToPoint();
  AddEquality(problem, Eigen::Vector2d(1, 1), 2.0);
  AddEquality(problem, Eigen::Vector2d(1, -1), 0.0);
  AddInequality(problem, Eigen::Vector2d(1, 0), 0.0, 1.0);
  const DenseQpSolution solution = SolveOnce(problem);
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector2d(1, 1)).norm(), 0.0, kNear);
  problem.upper(0) = 0.9;
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kInfeasible);
}

TEST(DenseQpTest, ContradictingEqualitiesAreInfeasible) {
  DenseQpProblem problem = DistanceToPoint();
  AddEquality(problem, Eigen::Vector2d(1, 1), 2.0);
  AddEquality(problem, Eigen::Vector2d(2, 2), 4.001);
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kInfeasible);
}

TEST(DenseQpTest, ContradictingInequalitiesAreInfeasible) {
  // x1 >= 1, x2 >= 1, x1 + x2 <= 1.9: no row contradicts another alone.
  DenseQpProblem problem = DistanceToPoint();
  AddInequality(problem, Eigen::Vector2d(1, 0), 1.0, kInfinity);
  AddInequality(problem, Eigen::Vector2d(0, 1), 1.0, kInfinity);
  AddInequality(problem, Eigen::Vector2d(1, 1), -kInfinity, 1.9);
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kInfeasible);
  problem.upper(2) = 2.0;  // one point is left
  const DenseQpSolution solution = SolveOnce(problem);
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector2d(1, 1)).norm(), 0.0, kNear);
}

TEST(DenseQpTest, InequalityAgainstEqualityIsInfeasible) {
  DenseQpProblem problem = DistanceToPoint();
  AddEquality(problem, Eigen::Vector2d(1, 1), 2.0);
  AddInequality(problem, Eigen::Vector2d(1, 1), 2.1, kInfinity);
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kInfeasible);
}

TEST(DenseQpTest, CrossedBoundsAreInfeasible) {
  DenseQpProblem problem = DistanceToPoint();
  AddInequality(problem, Eigen::Vector2d(1, 0), 1.0, 0.0);
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kInfeasible);
  problem.lower(0) = kInfinity;
  problem.upper(0) = kInfinity;
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kInfeasible);
}

TEST(DenseQpTest, CostFallingAlongARayIsUnbounded) {
  DenseQpProblem problem =
      Unconstrained(Eigen::Vector2d(1, 0).asDiagonal().toDenseMatrix(), Eigen::Vector2d(1, -1));
  AddInequality(problem, Eigen::Vector2d(0, 1), 0.0, kInfinity);
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kUnbounded);
  problem.upper(0) = 1e4;  // the same cost with a wall
  const DenseQpSolution solution = SolveOnce(problem);
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR(solution.x(1), 1e4, 1e-5);
}

TEST(DenseQpTest, FlatDirectionWithoutSlopeIsSolved) {
  const DenseQpSolution solution =
      SolveOnce(Unconstrained(Eigen::Matrix2d::Ones(), Eigen::Vector2d(-2, -2)));
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR(solution.x.sum(), 2.0, 1e-8);
}

TEST(DenseQpTest, ConcaveCostIsANumericalError) {
  DenseQpProblem problem =
      Unconstrained(Eigen::Vector2d(1, -1).asDiagonal().toDenseMatrix(), Eigen::Vector2d(0, 0));
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kNumericalError);
  AddEquality(problem, Eigen::Vector2d(0, 1), 3.0);  // convex on what is left
  EXPECT_EQ(SolveOnce(problem).status, QpStatus::kSolved);
}

TEST(DenseQpTest, NonFiniteDataIsANumericalErrorWhereverItIs) {
  DenseQpProblem good = DistanceToPoint();
  AddEquality(good, Eigen::Vector2d(1, 1), 2.0);
  AddInequality(good, Eigen::Vector2d(1, 0), -1.0, 1.0);
  ASSERT_EQ(SolveOnce(good).status, QpStatus::kSolved);
  const auto expect_error = [&](auto spoil) {
    DenseQpProblem bad = good;
    spoil(bad);
    const DenseQpSolution solution = SolveOnce(bad);
    EXPECT_EQ(solution.status, QpStatus::kNumericalError);
    EXPECT_EQ(solution.x, Eigen::VectorXd::Zero(2));
  };
  expect_error([](DenseQpProblem& p) { p.H(1, 0) = kNan; });
  expect_error([](DenseQpProblem& p) { p.g(1) = kInfinity; });
  expect_error([](DenseQpProblem& p) { p.A(0, 1) = -kInfinity; });
  expect_error([](DenseQpProblem& p) { p.b(0) = kNan; });
  expect_error([](DenseQpProblem& p) { p.C(0, 0) = kNan; });
  expect_error([](DenseQpProblem& p) { p.lower(0) = kNan; });
  expect_error([](DenseQpProblem& p) { p.upper(0) = kNan; });
}

TEST(DenseQpTest, NanDoesNotOutliveItsProblem) {
  DenseQpSolver solver({4, 4, 8});
  DenseQpProblem problem = DistanceToPoint();
  problem.g(0) = kNan;
  ASSERT_EQ(solver.Solve(problem).status, QpStatus::kNumericalError);
  problem.g(0) = -3.0;
  const DenseQpSolution& solution = solver.Solve(problem, &solver.Solve(problem));
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector2d(3, -4)).norm(), 0.0, kNear);
}

TEST(DenseQpTest, IterationLimitIsReported) {
  DenseQpProblem problem = DistanceToPoint();
  AddInequality(problem, Eigen::Vector2d(1, 0), -1.0, 1.0);
  AddInequality(problem, Eigen::Vector2d(0, 1), -1.0, 1.0);
  DenseQpOptions options;
  options.max_iterations = 1;
  DenseQpSolver solver({2, 0, 2}, options);
  const DenseQpSolution& solution = solver.Solve(problem);
  EXPECT_EQ(solution.status, QpStatus::kIterationLimit);
  EXPECT_EQ(solution.iterations, 1);
}

TEST(DenseQpTest, WrongGuessChangesNothingButThePath) {
  DenseQpProblem problem = DistanceToPoint();
  AddInequality(problem, Eigen::Vector2d(1, 0), -1.0, 1.0);
  AddInequality(problem, Eigen::Vector2d(0, 1), -1.0, kInfinity);
  DenseQpSolution guess;
  guess.inequality_multipliers = Eigen::Vector2d(-7.0, 7.0);  // wrong sides; one is infinite
  DenseQpSolver solver({2, 0, 2});
  const DenseQpSolution& solution = solver.Solve(problem, &guess);
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector2d(1, -1)).norm(), 0.0, kNear);
}

TEST(DenseQpTest, ViewsOfBlocksGiveWhatTheWholeProblemGives) {
  DenseQpProblem problem = DistanceToPoint();
  AddEquality(problem, Eigen::Vector2d(1, 1), 2.0);
  AddEquality(problem, Eigen::Vector2d(1, -1), 100.0);
  AddInequality(problem, Eigen::Vector2d(1, 0), -1.0, 1.0);
  AddInequality(problem, Eigen::Vector2d(0, 1), 50.0, 60.0);
  DenseQpSolver solver({2, 2, 2});
  const DenseQpSolution& solution =
      solver.Solve({problem.H, problem.g, problem.A.topRows(1), problem.b.head(1),
                    problem.C.topRows(1), problem.lower.head(1), problem.upper.head(1)});
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_NEAR((solution.x - Eigen::Vector2d(1, 1)).norm(), 0.0, kNear);
  EXPECT_EQ(solution.inequality_multipliers.size(), 1);
}

TEST(DenseQpTest, ShapesThatDisagreeOrExceedTheMaximaBreakTheContract) {
  DenseQpSolver solver({2, 0, 1});
  DenseQpProblem problem = DistanceToPoint();
  AddInequality(problem, Eigen::Vector2d(1, 0), -1.0, 1.0);
  EXPECT_EQ(solver.Solve(problem).status, QpStatus::kSolved);
  problem.upper.resize(0);
  EXPECT_THROW(solver.Solve(problem), ContractViolation);
  problem.upper.setZero(1);
  AddEquality(problem, Eigen::Vector2d(1, 1), 2.0);
  EXPECT_THROW(solver.Solve(problem), ContractViolation);
  EXPECT_THROW(DenseQpSolver({kMaxQpDimension + 1, 0, 0}), ContractViolation);
  EXPECT_THROW(DenseQpSolver({0, 0, 0}), ContractViolation);
}

}  // namespace
}  // namespace sidestep::wbc::dense_qp_test
