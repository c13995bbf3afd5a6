// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// null_space: which part of x the equalities fix, and which they leave free.
//
// Factors E' P = Q [R S; 0 0] by Householder reflections with column pivoting (Golub & Van Loan,
// "Matrix Computations", 5.4.2). Rows of E that depend on earlier pivots end up in S: they carry
// no multiplier, and whether they agree with the others shows in the residual of E x = e.

#include <Eigen/Core>

#include "controller/wbc/qp/kernels.h"

namespace sidestep::wbc::internal {

class NullSpace {
 public:
  /// Takes memory for `max_variables` columns and `max_rows` rows of E.
  NullSpace(int max_variables, int max_rows);

  /// n x rows block in which the caller writes E' (one row of E a column, each of norm 1 or 0)
  /// ahead of Factor(), which overwrites it.
  auto transposed_rows(int variables, int rows) { return factor_.topLeftCorner(variables, rows); }

  /// Factors what transposed_rows() holds.
  void Factor(int variables, int rows);

  int rank() const { return rank_; }

  /// Writes an orthonormal basis Z of the null space, n x (n - rank).
  void WriteBasis(MatrixRef basis) const;

  /// Smallest x with E x = e on the pivot rows. `e`: rows; `x`: n. Overwrites x.
  void SolveSmallest(const ConstVectorRef& e, VectorRef x) const;

  /// Multipliers nu (rows; 0 on dependent rows) that best satisfy E' nu = v. Overwrites v (n).
  void SolveMultipliers(VectorRef v, VectorRef nu) const;

 private:
  void Swap(Eigen::Index a, Eigen::Index b);

  int variables_{0};
  int rows_{0};
  int rank_{0};
  Eigen::MatrixXd factor_;    // R above the diagonal, reflectors below it (unit head implied)
  Eigen::VectorXd taus_;      // reflector k is I - tau_k v_k v_k'
  Eigen::VectorXd norms_sq_;  // of what is left of each column
  Eigen::VectorXi order_;     // column k of the factor is row order_(k) of E
  mutable Eigen::VectorXd buffer_;
};

}  // namespace sidestep::wbc::internal
