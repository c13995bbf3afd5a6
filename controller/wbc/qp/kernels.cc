// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/qp/kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sidestep::wbc::internal {

namespace {

// Two packed tiles of 96 x 96 doubles are 72 KiB each, under Eigen's 128 KiB for the stack.
constexpr Eigen::Index kTile = 96;

}  // namespace

void MultiplyByTranspose(const ConstMatrixRef& left, const ConstMatrixRef& right, MatrixRef out) {
  const Eigen::Index depth = left.cols();
  out.setZero();
  for (Eigen::Index i = 0; i < out.rows(); i += kTile) {
    const Eigen::Index rows = std::min(kTile, out.rows() - i);
    for (Eigen::Index j = 0; j < out.cols(); j += kTile) {
      const Eigen::Index cols = std::min(kTile, out.cols() - j);
      for (Eigen::Index k = 0; k < depth; k += kTile) {
        const Eigen::Index inner = std::min(kTile, depth - k);
        out.block(i, j, rows, cols).noalias() +=
            left.block(i, k, rows, inner) * right.block(j, k, cols, inner).transpose();
      }
    }
  }
}

void MultiplyBySparseTranspose(const ConstMatrixRef& left, const ConstMatrixRef& right,
                               MatrixRef out) {
  std::array<Eigen::Index, kTile> columns;  // where a stretch of a row is not zero
  out.setZero();
  for (Eigen::Index begin = 0; begin < right.cols(); begin += kTile) {
    const Eigen::Index end = std::min(begin + kTile, right.cols());
    for (Eigen::Index i = 0; i < right.rows(); ++i) {
      std::size_t count = 0;
      for (Eigen::Index j = begin; j < end; ++j) {
        columns[count] = j;
        count += right(i, j) != 0.0 ? 1 : 0;
      }
      std::size_t k = 0;
      auto sum = out.col(i);
      for (; k + 4 <= count; k += 4) {  // four at a time spare loads and stores of the sum
        sum += right(i, columns[k]) * left.col(columns[k]) +
               right(i, columns[k + 1]) * left.col(columns[k + 1]) +
               right(i, columns[k + 2]) * left.col(columns[k + 2]) +
               right(i, columns[k + 3]) * left.col(columns[k + 3]);
      }
      for (; k < count; ++k) {
        sum += right(i, columns[k]) * left.col(columns[k]);
      }
    }
  }
}

bool FactorCholesky(MatrixRef matrix, const ConstVectorRef& min_pivots) {
  const Eigen::Index size = matrix.rows();
  for (Eigen::Index j = 0; j < size; ++j) {
    auto column = matrix.col(j).tail(size - j);
    if (j > 0) {
      column.noalias() -= matrix.block(j, 0, size - j, j) * matrix.row(j).head(j).transpose();
    }
    const double pivot = column(0);
    if (!(pivot > 0.0 && pivot >= min_pivots(j))) {
      return false;
    }
    column *= 1.0 / std::sqrt(pivot);
  }
  return true;
}

void DivideByTransposedFactor(const ConstMatrixRef& factor, MatrixRef rows) {
  for (Eigen::Index j = 0; j < factor.cols(); ++j) {
    if (j > 0) {
      rows.col(j).noalias() -= rows.leftCols(j) * factor.row(j).head(j).transpose();
    }
    rows.col(j) *= 1.0 / factor(j, j);
  }
}

bool IsFinite(const ConstMatrixRef& matrix) {
  // 0 * x is zero for every finite x and NaN otherwise; unlike a test per entry it vectorises.
  return matrix.size() == 0 || (matrix.array() * 0.0).sum() == 0.0;
}

}  // namespace sidestep::wbc::internal
