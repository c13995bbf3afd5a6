// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// qp_workspace: the memory of DenseQpSolver and the steps of a solve.
//
//   rows of C -> pins (lower == upper), ranges, free        qp_reduction.cc
//   [A; pins] -> null space Z;  H -> Y with Y'HY = I        qp_reduction.cc
//   passes: equalities, projection in y                     qp_workspace.cc
//   residuals, certificate of unboundedness                 qp_residuals.cc
//
// x moves by x := x + Y y, so a pass only sees the residuals of the one before.

#include <Eigen/Core>

#include "controller/wbc/qp/dense_qp.h"
#include "controller/wbc/qp/null_space.h"
#include "controller/wbc/qp/projection.h"

namespace sidestep::wbc::internal {

/// All memory is taken by the constructor, for the largest problem that `maxima` allows; a solve of
/// any smaller one uses a corner of it and allocates nothing.
class QpWorkspace {
 public:
  QpWorkspace(const DenseQpDimensions& maxima, const DenseQpOptions& options);

  const DenseQpDimensions& maxima() const { return maxima_; }

  /// See DenseQpSolver::Solve; shapes are checked there.
  const DenseQpSolution& Solve(const DenseQpView& problem, const DenseQpSolution* guess);

 private:
  // qp_reduction.cc
  QpStatus ClassifyRows(const DenseQpView& problem);
  void ComputeScales(const DenseQpView& problem);
  void FactorEqualities(const DenseQpView& problem);
  bool FactorHessian(const DenseQpView& problem);
  void ReduceRanges(const DenseQpView& problem);

  // qp_workspace.cc
  void Start(const DenseQpView& problem, const DenseQpSolution* guess);
  QpStatus Reduce(const DenseQpView& problem);
  QpStatus RunPasses(const DenseQpView& problem);
  void CorrectEqualities(const DenseQpView& problem);
  bool SetProjection(const DenseQpView& problem);
  void ActivateGuess();
  void ReadMultipliers(const DenseQpView& problem);

  // qp_residuals.cc
  double EqualityViolation(const DenseQpView& problem);
  bool ComputeResiduals(const DenseQpView& problem);
  bool IsUnboundedRay(const DenseQpView& problem);

  double pin_value(const DenseQpView& problem, int row) const {
    return 0.5 * (problem.lower(row) + problem.upper(row));
  }

  DenseQpDimensions maxima_;
  DenseQpOptions options_;
  DenseQpSolution solution_;
  NullSpace null_space_;
  Projection projection_;

  int n_{0}, equalities_{0}, inequalities_{0};  // of the present problem
  int pins_{0}, ranges_{0};
  int free_{0};                 // columns of Y
  double regularisation_{0.0};  // rho, in scaled coordinates; 0 if H needs none
  double smallest_pivot_{1.0};  // of the Cholesky factor

  Eigen::VectorXi pin_row_, range_row_;  // rows of C
  Eigen::VectorXi guess_side_;           // -1 lower, 0 none, 1 upper, a row of C each
  Eigen::VectorXd scale_;                // D: x = D x_scaled
  Eigen::VectorXd row_scale_;            // 1 / |row| of [A; pins] D, 0 for a zero row
  Eigen::VectorXd range_norm_;           // |Y' c|; 0 if the equalities fix the row
  Eigen::MatrixXd basis_;                // n x free: D Z, then Y
  Eigen::MatrixXd basis_transposed_;     // free x n
  Eigen::MatrixXd hessian_basis_;        // free x n: Z' D H
  Eigen::MatrixXd hessian_, factor_;     // free x free
  Eigen::VectorXd min_pivots_;
  Eigen::MatrixXd range_rows_;  // free x m_i: Y' C'
  Eigen::VectorXd gradient_, step_, n_buffer_, n_buffer_2_;
  Eigen::VectorXd row_values_, row_buffer_, equality_buffer_, target_;
};

}  // namespace sidestep::wbc::internal
