// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/qp/dense_qp.h"

#include "controller/wbc/qp/qp_workspace.h"
#include "models/support/require.h"

namespace sidestep::wbc {

namespace {

void RequireShapes(const DenseQpView& problem, const DenseQpDimensions& maxima) {
  const Eigen::Index n = problem.H.rows();
  SIDESTEP_REQUIRE(n >= 1 && n <= maxima.variables, n);
  SIDESTEP_REQUIRE(problem.H.cols() == n, problem.H.cols());
  SIDESTEP_REQUIRE(problem.g.size() == n, problem.g.size());
  const Eigen::Index equalities = problem.b.size();
  SIDESTEP_REQUIRE(equalities <= maxima.equalities, equalities);
  SIDESTEP_REQUIRE(problem.A.rows() == equalities, problem.A.rows());
  SIDESTEP_REQUIRE(problem.A.cols() == n, problem.A.cols());
  const Eigen::Index inequalities = problem.lower.size();
  SIDESTEP_REQUIRE(inequalities <= maxima.inequalities, inequalities);
  SIDESTEP_REQUIRE(problem.upper.size() == inequalities, problem.upper.size());
  SIDESTEP_REQUIRE(problem.C.rows() == inequalities, problem.C.rows());
  SIDESTEP_REQUIRE(problem.C.cols() == n, problem.C.cols());
}

const DenseQpDimensions& RequireMaxima(const DenseQpDimensions& maxima) {
  SIDESTEP_REQUIRE(maxima.variables >= 1 && maxima.variables <= kMaxQpDimension, maxima.variables);
  SIDESTEP_REQUIRE(maxima.equalities >= 0 && maxima.equalities <= kMaxQpDimension,
                   maxima.equalities);
  SIDESTEP_REQUIRE(maxima.inequalities >= 0 && maxima.inequalities <= kMaxQpDimension,
                   maxima.inequalities);
  return maxima;
}

}  // namespace

DenseQpSolver::DenseQpSolver(const DenseQpDimensions& maxima, const DenseQpOptions& options)
    : workspace_(std::make_unique<internal::QpWorkspace>(RequireMaxima(maxima), options)) {}

DenseQpSolver::~DenseQpSolver() = default;
DenseQpSolver::DenseQpSolver(const DenseQpSolver& other)
    : workspace_(std::make_unique<internal::QpWorkspace>(*other.workspace_)) {}

DenseQpSolver& DenseQpSolver::operator=(const DenseQpSolver& other) {
  return *this = DenseQpSolver(other);
}

DenseQpSolver::DenseQpSolver(DenseQpSolver&&) noexcept = default;
DenseQpSolver& DenseQpSolver::operator=(DenseQpSolver&&) noexcept = default;

const DenseQpSolution& DenseQpSolver::Solve(const DenseQpView& problem,
                                            const DenseQpSolution* guess) {
  RequireShapes(problem, workspace_->maxima());
  return workspace_->Solve(problem, guess);
}

}  // namespace sidestep::wbc
