// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/random_dense_qp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/whole_body_qp.h"

namespace sidestep::wbc {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bounds around C * feasible: a third one-sided, a quarter touching the feasible point.
void SetBounds(SeededNumbers& numbers, const VectorXd& feasible, DenseQpProblem& problem) {
  const VectorXd values = problem.C * feasible;
  problem.lower.resize(values.size());
  problem.upper.resize(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const auto margin = [&] {
      return numbers.Uniform(0.0, 1.0) < 0.25 ? 0.0 : numbers.Uniform(0.01, 2.0);
    };
    problem.lower(i) = values(i) - margin();
    problem.upper(i) = values(i) + margin() + 1e-3;
    const double kind = numbers.Uniform(0.0, 1.0);
    if (kind < 0.17) {
      problem.lower(i) = -kInfinity;
    } else if (kind < 0.34) {
      problem.upper(i) = kInfinity;
    }
  }
}

DenseQpProblem Generic(SeededNumbers& numbers, VectorXd& feasible) {
  const int n = numbers.Integer(4, 20);
  const int equalities = numbers.Integer(0, n / 2);
  const int inequalities = numbers.Integer(1, 2 * n);
  DenseQpProblem problem;
  problem.H = RandomPositiveDefinite(numbers, n, n, 0.1);
  problem.g = 3.0 * numbers.NormalMatrix(n, 1);
  problem.A = numbers.NormalMatrix(equalities, n);
  problem.C = numbers.NormalMatrix(inequalities, n);
  feasible = numbers.NormalMatrix(n, 1);
  problem.b = problem.A * feasible;
  SetBounds(numbers, feasible, problem);
  return problem;
}

// Adds -5 <= x - feasible <= 5 as rows.
void AddBox(const VectorXd& feasible, DenseQpProblem& problem) {
  const Eigen::Index n = feasible.size();
  const Eigen::Index rows = problem.C.rows();
  problem.C.conservativeResize(rows + n, n);
  problem.C.bottomRows(n).setIdentity();
  problem.lower.conservativeResize(rows + n);
  problem.upper.conservativeResize(rows + n);
  problem.lower.tail(n) = feasible.array() - 5.0;
  problem.upper.tail(n) = feasible.array() + 5.0;
}

void DuplicateRows(SeededNumbers& numbers, DenseQpProblem& problem) {
  const Eigen::Index n = problem.g.size();
  const Eigen::Index m = problem.A.rows();
  problem.A.conservativeResize(2 * m, n);
  problem.b.conservativeResize(2 * m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const double factor = numbers.Uniform(-3.0, 3.0);
    const Eigen::Index other = numbers.Integer(0, static_cast<int>(m) - 1);
    problem.A.row(m + i) = factor * problem.A.row(i) + problem.A.row(other);
    problem.b(m + i) = factor * problem.b(i) + problem.b(other);
  }
  const Eigen::Index k = problem.C.rows();
  problem.C.conservativeResize(2 * k, n);
  problem.lower.conservativeResize(2 * k);
  problem.upper.conservativeResize(2 * k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const double factor = i % 2 == 0 ? 1.0 : numbers.Uniform(0.1, 5.0);
    problem.C.row(k + i) = factor * problem.C.row(i);
    problem.lower(k + i) = factor * problem.lower(i);
    problem.upper(k + i) = factor * problem.upper(i);
  }
}

void ScaleBadly(SeededNumbers& numbers, DenseQpProblem& problem) {
  const auto factor = [&] { return std::pow(10.0, numbers.Uniform(-2.0, 2.0)); };
  for (Eigen::Index j = 0; j < problem.g.size(); ++j) {
    const double s = factor();
    problem.H.row(j) *= s;
    problem.H.col(j) *= s;
    problem.g(j) *= s;
    problem.A.col(j) *= s;
    problem.C.col(j) *= s;
  }
  for (Eigen::Index i = 0; i < problem.b.size(); ++i) {
    const double s = factor();
    problem.A.row(i) *= s;
    problem.b(i) *= s;
  }
  for (Eigen::Index i = 0; i < problem.lower.size(); ++i) {
    const double s = factor();
    problem.C.row(i) *= s;
    problem.lower(i) *= s;
    problem.upper(i) *= s;
  }
}

// 2 n rows through the feasible point, integer coefficients so that many are dependent.
void MakeDegenerate(SeededNumbers& numbers, const VectorXd& feasible, DenseQpProblem& problem) {
  const Eigen::Index n = feasible.size();
  problem.C.resize(2 * n, n);
  for (Eigen::Index i = 0; i < problem.C.size(); ++i) {
    problem.C.data()[i] = numbers.Integer(-1, 1);
  }
  problem.lower = problem.C * feasible;
  problem.upper = VectorXd::Constant(2 * n, kInfinity);
  for (Eigen::Index i = 0; i < 2 * n; i += 5) {
    problem.upper(i) = problem.lower(i) + 1.0;
  }
}

DenseQpProblem MakeGeneric(QpFamily family, SeededNumbers& numbers) {
  VectorXd feasible;
  DenseQpProblem problem = Generic(numbers, feasible);
  const int n = static_cast<int>(feasible.size());
  switch (family) {
    case QpFamily::kSemiDefinite:
      problem.H = RandomPositiveDefinite(numbers, n, n / 2, 0.0);
      AddBox(feasible, problem);
      break;
    case QpFamily::kLinear:
      problem.H.setZero();
      AddBox(feasible, problem);
      break;
    case QpFamily::kDuplicateRows:
      DuplicateRows(numbers, problem);
      break;
    case QpFamily::kPins: {
      const VectorXd values = problem.C * feasible;
      // Few enough that equalities and pins together leave a degree of freedom.
      const Eigen::Index pins = std::min<Eigen::Index>(values.size() / 3, n / 2 - 1);
      problem.lower.head(pins) = values.head(pins);
      problem.upper.head(pins) = values.head(pins);
      break;
    }
    case QpFamily::kBadlyScaled:
      ScaleBadly(numbers, problem);
      break;
    case QpFamily::kDegenerateVertex:
      MakeDegenerate(numbers, feasible, problem);
      break;
    default:
      break;
  }
  return problem;
}

}  // namespace

const char* ToString(QpFamily family) {
  switch (family) {
    case QpFamily::kStrictlyConvex:
      return "strictly_convex";
    case QpFamily::kSemiDefinite:
      return "semi_definite";
    case QpFamily::kLinear:
      return "linear";
    case QpFamily::kDuplicateRows:
      return "duplicate_rows";
    case QpFamily::kPins:
      return "pins";
    case QpFamily::kBadlyScaled:
      return "badly_scaled";
    case QpFamily::kDegenerateVertex:
      return "degenerate_vertex";
    case QpFamily::kHopper:
      return "hopper";
    case QpFamily::kVelocity:
      return "velocity";
    case QpFamily::kTorque:
      return "torque";
  }
  return "unknown";
}

bool IsStrictlyConvex(QpFamily family) {
  return family != QpFamily::kSemiDefinite && family != QpFamily::kLinear;
}

double SeededNumbers::Uniform(double low, double high) {
  constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
  return low + (high - low) * kUnit * static_cast<double>(engine_() >> 11);
}

double SeededNumbers::Normal() {  // Box & Muller
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform(0.0, 1.0)));
  return radius * std::cos(2.0 * std::numbers::pi * Uniform(0.0, 1.0));
}

int SeededNumbers::Integer(int low, int high) {
  return low + static_cast<int>(Uniform(0.0, static_cast<double>(high - low + 1)));
}

Eigen::Vector3d SeededNumbers::Vector3(double size) {
  Eigen::Vector3d vector;
  for (double& entry : vector) entry = Uniform(-size, size);
  return vector;
}

Eigen::Quaterniond SeededNumbers::Turn(double size_rad) {
  const Eigen::Vector3d turn = Vector3(size_rad);
  return Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
}

Eigen::MatrixXd SeededNumbers::NormalMatrix(Eigen::Index rows, Eigen::Index cols) {
  MatrixXd matrix(rows, cols);
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    matrix.data()[i] = Normal();
  }
  return matrix;
}

Eigen::MatrixXd RandomPositiveDefinite(SeededNumbers& numbers, int size, int rank, double shift) {
  const Eigen::MatrixXd factor = numbers.NormalMatrix(size, rank);
  return factor * factor.transpose() / std::sqrt(static_cast<double>(size)) +
         shift * Eigen::MatrixXd::Identity(size, size);
}

DenseQpProblem MakeRandomQp(QpFamily family, std::uint64_t seed) {
  SeededNumbers numbers(seed * 1000 + static_cast<std::uint64_t>(family));
  switch (family) {
    case QpFamily::kHopper:
      return MakeHopperQp(numbers);
    case QpFamily::kVelocity:
      return MakeVelocityQp(numbers);
    case QpFamily::kTorque:
      return MakeTorqueQp(numbers);
    default:
      return MakeGeneric(family, numbers);
  }
}

DenseQpProblem MakeNeighbourQp(const DenseQpProblem& problem, std::uint64_t seed) {
  SeededNumbers numbers(seed);
  DenseQpProblem next = problem;
  const Eigen::Index n = problem.g.size();
  const VectorXd shift = 1e-3 * numbers.NormalMatrix(n, 1);
  next.g += 0.01 * problem.g.cwiseProduct(numbers.NormalMatrix(n, 1));
  next.b += problem.A * shift;
  const VectorXd moved = problem.C * shift;
  next.lower += moved;
  next.upper += moved;
  return next;
}

DenseQpDimensions RandomQpMaxima() { return {59, 40, 100}; }

}  // namespace sidestep::wbc
