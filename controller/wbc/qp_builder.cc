// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/qp_builder.h"

#include "models/support/require.h"

namespace sidestep::wbc {

QpBuilder::QpBuilder(const DenseQpDimensions& maxima) {
  qp_.H.setZero(maxima.variables, maxima.variables);
  qp_.g.setZero(maxima.variables);
  qp_.A.setZero(maxima.equalities, maxima.variables);
  qp_.b.setZero(maxima.equalities);
  qp_.C.setZero(maxima.inequalities, maxima.variables);
  qp_.lower.setZero(maxima.inequalities);
  qp_.upper.setZero(maxima.inequalities);
}

void QpBuilder::Start(Eigen::Index variables) {
  SIDESTEP_REQUIRE(variables <= qp_.g.size(), variables);
  variables_ = variables;
  equalities_ = 0;
  inequalities_ = 0;
  qp_.H.topLeftCorner(variables, variables).setZero();
  qp_.g.head(variables).setZero();
}

void QpBuilder::AddTask(const Task& task, double weight) {
  const Eigen::Index nv = task.J.cols();
  qp_.H.topLeftCorner(nv, nv).noalias() += weight * task.J.transpose() * task.J;
  qp_.g.head(nv).noalias() -= weight * task.J.transpose() * task.target;
}

void QpBuilder::AddTask(const Task& task, double weight, std::span<const int> axes) {
  const Eigen::Index nv = task.J.cols();
  for (const int axis : axes) {
    const auto row = task.J.row(axis);
    qp_.H.topLeftCorner(nv, nv).noalias() += weight * row.transpose() * row;
    qp_.g.head(nv).noalias() -= weight * task.target[axis] * row.transpose();
  }
}

void QpBuilder::AddTaskOn(Eigen::Index first, const Eigen::Ref<const Eigen::MatrixXd>& J,
                          const Eigen::Vector3d& target, double weight) {
  const Eigen::Index size = J.cols();
  SIDESTEP_REQUIRE(first + size <= variables_, size);
  qp_.H.block(first, first, size, size).noalias() += weight * J.transpose() * J;
  qp_.g.segment(first, size).noalias() -= weight * J.transpose() * target;
}

void QpBuilder::AddDiagonal(Eigen::Index variable, double target, double weight) {
  qp_.H(variable, variable) += weight;
  qp_.g[variable] -= weight * target;
}

void QpBuilder::AddExact(const Task& task, std::span<const int> axes) {
  EqualityRows rows = AddEqualities(static_cast<Eigen::Index>(axes.size()));
  Eigen::Index row = 0;
  for (const int axis : axes) {
    rows.A.row(row).head(task.J.cols()) = task.J.row(axis);
    rows.b[row++] = task.target[axis];
  }
}

EqualityRows QpBuilder::AddEqualities(Eigen::Index rows) {
  const Eigen::Index first = equalities_;
  equalities_ += rows;
  SIDESTEP_REQUIRE(equalities_ <= qp_.b.size(), equalities_);
  qp_.A.block(first, 0, rows, variables_).setZero();
  qp_.b.segment(first, rows).setZero();
  return {qp_.A.block(first, 0, rows, variables_), qp_.b.segment(first, rows)};
}

InequalityRows QpBuilder::AddInequalities(Eigen::Index rows) {
  const Eigen::Index first = inequalities_;
  inequalities_ += rows;
  SIDESTEP_REQUIRE(inequalities_ <= qp_.lower.size(), inequalities_);
  qp_.C.block(first, 0, rows, variables_).setZero();
  qp_.lower.segment(first, rows).setConstant(-kInfinity);
  qp_.upper.segment(first, rows).setConstant(kInfinity);
  return {qp_.C.block(first, 0, rows, variables_), qp_.lower.segment(first, rows),
          qp_.upper.segment(first, rows)};
}

void QpBuilder::DropEqualities(Eigen::Index rows) {
  SIDESTEP_REQUIRE(rows <= equalities_, rows);
  equalities_ -= rows;
}

DenseQpView QpBuilder::View() const {
  return {qp_.H.topLeftCorner(variables_, variables_),
          qp_.g.head(variables_),
          qp_.A.topLeftCorner(equalities_, variables_),
          qp_.b.head(equalities_),
          qp_.C.topLeftCorner(inequalities_, variables_),
          qp_.lower.head(inequalities_),
          qp_.upper.head(inequalities_)};
}

}  // namespace sidestep::wbc
