// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/whole_body_qp.h"

#include <algorithm>

namespace sidestep::wbc {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// One friction pyramid of slope 0.7 with 0 <= f_z <= 500 N: five rows on three columns.
void WriteFrictionRows(int row, int column, DenseQpProblem& problem) {
  constexpr double kSlope = 0.7;
  problem.C.block(row, column, 5, 3) << 1, 0, -kSlope, -1, 0, -kSlope, 0, 1, -kSlope, 0, -1,
      -kSlope, 0, 0, 1;
  problem.lower.segment(row, 5) << -kInfinity, -kInfinity, -kInfinity, -kInfinity, 0.0;
  problem.upper.segment(row, 5) << 0.0, 0.0, 0.0, 0.0, 500.0;
}

// Inverse dynamics: M qdd + h = S' tau + J' f, feet at rest (J qdd = -Jdot v), tau eliminated.
// x = [qdd (m/s^2, rad/s^2); f (N); slacks of a soft task]. Corners make J rank-deficient.
// `feasible` gets a feasible point.
DenseQpProblem InverseDynamics(SeededNumbers& numbers, int dofs, int corners, int slacks,
                               VectorXd& feasible) {
  const int n = dofs + 3 * corners + slacks;
  const int joints = dofs - (slacks > 0 ? 6 : 3);
  const int base = dofs - joints;
  const MatrixXd mass = RandomPositiveDefinite(numbers, dofs, dofs, 2.0);
  // A foot's motion has six components; each corner's three are combinations of those.
  const int feet = slacks > 0 ? 2 : 1;
  MatrixXd jacobian(3 * corners, dofs);
  const int per_foot = 3 * corners / feet;
  for (int foot = 0; foot < feet; ++foot) {
    jacobian.middleRows(foot * per_foot, per_foot) =
        numbers.NormalMatrix(per_foot, std::min(6, per_foot)) *
        numbers.NormalMatrix(std::min(6, per_foot), dofs);
  }
  feasible = VectorXd::Zero(n);
  feasible.head(dofs) = 5.0 * numbers.NormalMatrix(dofs, 1);
  for (int c = 0; c < corners; ++c) {
    // Every fourth corner is in the air: its force is pinned to zero by 0 <= f_z <= 0.
    const double vertical_N = c % 4 == 3 ? 0.0 : numbers.Uniform(20.0, 150.0);
    feasible.segment(dofs + 3 * c, 3) << 0.3 * vertical_N, -0.2 * vertical_N, vertical_N;
  }
  DenseQpProblem problem;
  problem.A = MatrixXd::Zero(base + 3 * corners + slacks, n);
  problem.A.topLeftCorner(base, dofs) = mass.topRows(base);
  problem.A.block(0, dofs, base, 3 * corners) = -jacobian.leftCols(base).transpose();
  problem.A.block(base, 0, 3 * corners, dofs) = jacobian;
  if (slacks > 0) {  // a soft task, held through slack variables
    problem.A.bottomLeftCorner(slacks, dofs) = numbers.NormalMatrix(slacks, dofs);
    problem.A.bottomRightCorner(slacks, slacks) = MatrixXd::Identity(slacks, slacks);
  }
  problem.b = problem.A * feasible;

  const int limits = slacks > 0 ? dofs : 5;
  const int rows = 5 * corners + joints + limits;
  problem.C = MatrixXd::Zero(rows, n);
  problem.lower.resize(rows);
  problem.upper.resize(rows);
  problem.C.block(5 * corners, 0, joints, dofs) = mass.bottomRows(joints);
  problem.C.block(5 * corners, dofs, joints, 3 * corners) = -jacobian.rightCols(joints).transpose();
  problem.C.block(5 * corners + joints, 0, limits, limits).setIdentity();
  const VectorXd values = problem.C * feasible;
  for (int i = 5 * corners; i < rows; ++i) {
    const double range = i < 5 * corners + joints ? 60.0 : 10.0;
    problem.lower(i) = values(i) - numbers.Uniform(0.0, range);
    problem.upper(i) = values(i) + numbers.Uniform(0.0, range);
  }
  for (int c = 0; c < corners; ++c) {
    WriteFrictionRows(5 * c, dofs + 3 * c, problem);
    if (c % 4 == 3) {
      problem.upper(5 * c + 4) = 0.0;
    }
  }
  const MatrixXd task = numbers.NormalMatrix(dofs / 2 + 1, dofs);
  problem.H = 1e-6 * MatrixXd::Identity(n, n);  // forces: (1e-3 / N)^2
  problem.H.topLeftCorner(dofs, dofs) +=
      task.transpose() * task + 1e-2 * MatrixXd::Identity(dofs, dofs);
  problem.H.bottomRightCorner(slacks, slacks) += 100.0 * MatrixXd::Identity(slacks, slacks);
  problem.g = VectorXd::Zero(n);
  problem.g.head(dofs) = -task.transpose() * (10.0 * numbers.NormalMatrix(task.rows(), 1));
  return problem;
}

}  // namespace

DenseQpProblem MakeVelocityQp(SeededNumbers& numbers) {
  constexpr int kN = 29, kJoints = 23, kExact = 15, kTask = 12;
  DenseQpProblem problem;
  const MatrixXd task = numbers.NormalMatrix(kTask, kN);
  problem.H = task.transpose() * task + 1e-3 * MatrixXd::Identity(kN, kN);
  problem.g = -task.transpose() * numbers.NormalMatrix(kTask, 1);
  problem.A = numbers.NormalMatrix(kExact, kN);
  const VectorXd feasible = 0.5 * numbers.NormalMatrix(kN, 1);
  problem.b = problem.A * feasible;
  problem.C = MatrixXd::Zero(2 * kJoints, kN);  // velocity limits, then position limits
  problem.C.topRightCorner(kJoints, kJoints).setIdentity();
  problem.C.bottomRightCorner(kJoints, kJoints).setIdentity();
  const VectorXd joints = problem.C * feasible;
  problem.lower = joints - 0.3 * numbers.NormalMatrix(2 * kJoints, 1).cwiseAbs();
  problem.upper = joints + 0.3 * numbers.NormalMatrix(2 * kJoints, 1).cwiseAbs();
  return problem;
}

DenseQpProblem MakeHopperQp(SeededNumbers& numbers) {
  VectorXd feasible;
  DenseQpProblem problem = InverseDynamics(numbers, 9, 1, 0, feasible);
  const Eigen::Index rows = problem.A.rows();
  problem.A.conservativeResize(rows + 3, 12);
  problem.A.bottomRows(3) = numbers.NormalMatrix(3, 12);
  problem.A.bottomRightCorner(3, 3).setZero();
  problem.b.conservativeResize(rows + 3);
  problem.b.tail(3) = problem.A.bottomRows(3) * feasible;
  return problem;
}

DenseQpProblem MakeTorqueQp(SeededNumbers& numbers) {
  VectorXd feasible;
  return InverseDynamics(numbers, 29, 8, 6, feasible);
}

}  // namespace sidestep::wbc
