// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// kernels: the few dense operations of the QP, none of which allocates at any size.
//
// Eigen's matrix products and triangular solves take their workspace from the heap once it
// exceeds 128 KiB; these stay below it by working in tiles.

#include <Eigen/Core>

namespace sidestep::wbc::internal {

using MatrixRef = Eigen::Ref<Eigen::MatrixXd>;
using VectorRef = Eigen::Ref<Eigen::VectorXd>;
using ConstMatrixRef = Eigen::Ref<const Eigen::MatrixXd>;
using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;

/// out = left * right', with left r x n, right m x n, out r x m (not overlapping the inputs).
void MultiplyByTranspose(const ConstMatrixRef& left, const ConstMatrixRef& right, MatrixRef out);

/// As MultiplyByTranspose, but skips the zeros of `right` where it has many of them: bounds and
/// friction rows touch one to three variables.
void MultiplyBySparseTranspose(const ConstMatrixRef& left, const ConstMatrixRef& right,
                               MatrixRef out);

/// Factors a symmetric matrix as L L' in place (lower triangle read and written).
/// @param min_pivots  smallest accepted square of each diagonal entry of L.
/// @return            false, with `matrix` half-written, if a pivot is below its minimum or NaN.
bool FactorCholesky(MatrixRef matrix, const ConstVectorRef& min_pivots);

/// rows := rows * L^-T, for L of FactorCholesky; rows is n x r, L is r x r.
void DivideByTransposedFactor(const ConstMatrixRef& factor, MatrixRef rows);

/// True if every entry is finite.
bool IsFinite(const ConstMatrixRef& matrix);

}  // namespace sidestep::wbc::internal
