// SPDX-License-Identifier: BSD-3-Clause
// Cost and rows against the definition: half the weighted squares of what the tasks leave.
#include "controller/wbc/qp_builder.h"

#include <gtest/gtest.h>

#include <array>

#include "models/support/require.h"
#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc::qp_builder_test {
namespace {

constexpr Eigen::Index kVelocities = 7, kVariables = 9;
constexpr double kRounding = 1e-12;

class QpBuilderTest : public testing::Test {
 protected:
  QpBuilderTest() { qp_.Start(kVariables); }

  /// x' H x / 2 + g' x, but for a constant what the tasks' squares come to.
  double Cost(const Eigen::VectorXd& x) const {
    const DenseQpView view = qp_.View();
    return 0.5 * x.dot(view.H * x) + view.g.dot(x);
  }

  SeededNumbers numbers_{3};
  const Jacobian3 J_{numbers_.NormalMatrix(3, kVelocities)};
  const Eigen::Vector3d target_{0.5, -2.0, 1.0};
  const Task task_{J_, target_};
  const Eigen::VectorXd x_{numbers_.NormalMatrix(kVariables, 1)};
  QpBuilder qp_{{12, 8, 5}};
};

TEST_F(QpBuilderTest, TaskCostsTheWeightedSquareOfWhatItLeaves) {
  qp_.AddTask(task_, 2.0);
  const Eigen::Vector3d left = J_ * x_.head(kVelocities) - target_;
  const double expected = 0.5 * 2.0 * left.squaredNorm();
  const double at_zero = 0.5 * 2.0 * target_.squaredNorm();
  EXPECT_NEAR(Cost(x_) + at_zero, expected, kRounding * expected);
  EXPECT_GT(expected, 1.0);
}

TEST_F(QpBuilderTest, OfATaskOnlyTheNamedRowsAreWeighed) {
  qp_.AddTask(task_, 2.0, std::array{0, 2});
  Eigen::Vector3d left = J_ * x_.head(kVelocities) - target_;
  Eigen::Vector3d target = target_;
  left.y() = target.y() = 0.0;
  EXPECT_NEAR(Cost(x_) + target.squaredNorm(), left.squaredNorm(), kRounding * left.squaredNorm());
  QpBuilder other{{12, 8, 5}};
  other.Start(kVariables);
  other.AddTask(task_, 2.0, kAllAxes);
  qp_.Start(kVariables);
  qp_.AddTask(task_, 2.0);
  EXPECT_LT((qp_.View().H - other.View().H).norm(), kRounding * qp_.View().H.norm());
  EXPECT_LT((qp_.View().g - other.View().g).norm(), kRounding * qp_.View().g.norm());
}

TEST_F(QpBuilderTest, TaskOnSomeVariablesIsATaskWithZerosBefore) {
  QpBuilder other{{12, 8, 5}};
  other.Start(kVariables);
  const Eigen::MatrixXd J = numbers_.NormalMatrix(3, 4);
  Jacobian3 padded = Jacobian3::Zero(3, 7);
  padded.rightCols<4>() = J;
  qp_.AddTaskOn(3, J, target_, 0.7);
  other.AddTask({padded, target_}, 0.7);
  EXPECT_LT((qp_.View().H - other.View().H).norm(), kRounding);
  EXPECT_LT((qp_.View().g - other.View().g).norm(), kRounding);
  EXPECT_GT(qp_.View().H.norm(), 1.0);
  EXPECT_THROW(qp_.AddTaskOn(kVariables - 3, J, target_, 0.7), ContractViolation);
}

TEST_F(QpBuilderTest, TasksAndDiagonalsAddUp) {
  qp_.AddTask(task_, 1.0);
  const double task_alone = Cost(x_);
  qp_.AddDiagonal(8, 3.0, 4.0);
  qp_.AddDiagonal(8, -1.0, 2.0);
  const double diagonal =
      0.5 * 4.0 * (std::pow(x_[8] - 3.0, 2) - 9.0) + 0.5 * 2.0 * (std::pow(x_[8] + 1.0, 2) - 1.0);
  EXPECT_NEAR(Cost(x_), task_alone + diagonal, kRounding * (1.0 + std::abs(Cost(x_))));
}

TEST_F(QpBuilderTest, ExactTasksAreEqualitiesInTheOrderOfTheirCalls) {
  qp_.AddExact(task_);
  EqualityRows rows = qp_.AddEqualities(2);
  rows.A(1, 8) = 4.0;
  rows.b[1] = 6.0;
  qp_.AddExact({J_, 2.0 * target_});
  const DenseQpView view = qp_.View();
  ASSERT_EQ(view.A.rows(), 8);
  ASSERT_EQ(view.A.cols(), kVariables);
  EXPECT_EQ(view.A.topLeftCorner(3, kVelocities), J_);
  EXPECT_EQ(view.A.topRightCorner(3, 2).norm(), 0.0) << "of the velocities only";
  EXPECT_EQ(view.A.row(3).norm(), 0.0);
  EXPECT_EQ(view.A(4, 8), 4.0);
  EXPECT_EQ(view.A.bottomLeftCorner(3, kVelocities), J_);
  Eigen::VectorXd b(8);
  b << target_, 0.0, 6.0, 2.0 * target_;
  EXPECT_EQ(view.b, b);
}

TEST_F(QpBuilderTest, DroppedEqualitiesAreTheLastOnes) {
  qp_.AddExact(task_);
  qp_.AddExact({J_, 2.0 * target_});
  qp_.DropEqualities(3);
  ASSERT_EQ(qp_.View().b.size(), 3);
  EXPECT_EQ(Eigen::VectorXd(qp_.View().b), target_);
  EXPECT_THROW(qp_.DropEqualities(4), ContractViolation);
}

TEST_F(QpBuilderTest, NewInequalitiesBoundNothingUntilTheyAreFilledIn) {
  InequalityRows rows = qp_.AddInequalities(2);
  rows.C(0, 3) = 1.0;
  rows.lower[0] = -5.0;
  const DenseQpView view = qp_.View();
  ASSERT_EQ(view.C.rows(), 2);
  EXPECT_EQ(view.C.norm(), 1.0);
  EXPECT_EQ(view.C(0, 3), 1.0);
  EXPECT_EQ(view.lower[0], -5.0);
  EXPECT_EQ(view.upper[0], kInfinity);
  EXPECT_EQ(view.lower[1], -kInfinity);
}

TEST_F(QpBuilderTest, StartLeavesNothingOfTheProblemBefore) {
  qp_.AddTask(task_, 1.0);
  qp_.AddDiagonal(8, 1.0, 1.0);
  qp_.AddExact(task_);
  qp_.AddInequalities(5).C.setOnes();
  qp_.Start(12);  // as large as it gets
  EXPECT_EQ(qp_.View().H, Eigen::MatrixXd::Zero(12, 12));
  EXPECT_EQ(qp_.View().g, Eigen::VectorXd::Zero(12));
  EXPECT_EQ(qp_.View().b.size() + qp_.View().lower.size(), 0);
  EXPECT_EQ(qp_.AddEqualities(8).A, Eigen::MatrixXd::Zero(8, 12));
  EXPECT_EQ(qp_.AddInequalities(5).C, Eigen::MatrixXd::Zero(5, 12));
}

TEST_F(QpBuilderTest, BeyondItsMaximaItBreaksTheContract) {
  EXPECT_THROW(qp_.Start(13), ContractViolation);
  EXPECT_THROW(qp_.AddEqualities(9), ContractViolation);
  EXPECT_THROW(qp_.AddInequalities(6), ContractViolation);
}

TEST_F(QpBuilderTest, SolvedTheExactTaskHoldsAndTheOthersShareTheRest) {
  qp_.AddExact(task_);
  const Jacobian3 other = numbers_.NormalMatrix(3, kVelocities);
  qp_.AddTask({other, Eigen::Vector3d::Ones()}, 10.0);
  for (Eigen::Index i = 0; i < kVariables; ++i) qp_.AddDiagonal(i, 0.0, 1e-6);
  DenseQpSolver solver({12, 8, 5});
  const DenseQpSolution& solution = solver.Solve(qp_.View());
  ASSERT_EQ(solution.status, QpStatus::kSolved);
  EXPECT_LT((J_ * solution.x.head(kVelocities) - target_).norm(), 1e-8);
  // Seven variables, six rows: both fit, but for the diagonal's 1e-7 of it.
  EXPECT_LT((other * solution.x.head(kVelocities) - Eigen::Vector3d::Ones()).norm(), 1e-5);
}

}  // namespace
}  // namespace sidestep::wbc::qp_builder_test
