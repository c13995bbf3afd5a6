// SPDX-License-Identifier: BSD-3-Clause
// The change of coordinates: from the caller's problem to a projection onto a polyhedron.
#include <algorithm>
#include <cmath>

#include "controller/wbc/qp/kernels.h"
#include "controller/wbc/qp/qp_workspace.h"

namespace sidestep::wbc::internal {

namespace {

// Bounds closer than this (relative) are one equality: a gap of rounding size has no inside.
constexpr double kPinGap = 1e-12;

// Diagonal entries of H below this share of the largest don't set a variable's scale.
constexpr double kSmallestCurvature = 1e-8;

// A Cholesky pivot needs this share of its own diagonal entry, and of the largest one; below that
// the direction is flat as far as rounding lets us see.
constexpr double kPivotShare = 1e-9;
constexpr double kPivotFloor = 1e-12;

// First proximal weight relative to the largest reduced curvature, and how far it may grow before
// H is called non-convex. Small: few passes; large: little cancellation. Tuned on the unit test.
constexpr double kRegularisation = 1e-8;
constexpr double kMaxRegularisation = 1e-5;
constexpr double kRegularisationGrowth = 30.0;

// Reduced curvatures below this (H scaled to a largest diagonal of 1) are zero, as in an LP.
constexpr double kZeroCurvature = 1e-13;

// A row of C whose reduced part is smaller than this share of it is fixed by the equalities.
constexpr double kFixedShare = 1e-11;

}  // namespace

QpStatus QpWorkspace::ClassifyRows(const DenseQpView& problem) {
  pins_ = 0;
  ranges_ = 0;
  for (int i = 0; i < inequalities_; ++i) {
    const double lower = problem.lower(i);
    const double upper = problem.upper(i);
    if (std::isnan(lower) || std::isnan(upper)) {
      return QpStatus::kNumericalError;
    }
    if (lower == kInfinity || upper == -kInfinity) {
      return QpStatus::kInfeasible;
    }
    if (lower == -kInfinity && upper == kInfinity) {
      continue;
    }
    const double size = 1.0 + std::min(std::abs(lower), std::abs(upper));
    if (lower - upper > options_.tolerance * size) {
      return QpStatus::kInfeasible;
    }
    if (upper - lower <= kPinGap * size) {
      pin_row_(pins_++) = i;
    } else {
      range_row_(ranges_++) = i;
    }
  }
  return QpStatus::kNotSolved;
}

void QpWorkspace::ComputeScales(const DenseQpView& problem) {
  const auto diagonal = problem.H.diagonal();
  const double largest = diagonal.maxCoeff();
  auto scale = scale_.head(n_);
  if (largest > 0.0) {
    scale = diagonal.cwiseMax(kSmallestCurvature * largest).cwiseSqrt().cwiseInverse();
  } else {
    scale.setOnes();
  }
}

void QpWorkspace::FactorEqualities(const DenseQpView& problem) {
  const int rows = equalities_ + pins_;
  auto transposed = null_space_.transposed_rows(n_, rows);
  for (int i = 0; i < rows; ++i) {
    auto column = transposed.col(i);
    if (i < equalities_) {
      column = problem.A.row(i).transpose();
    } else {
      column = problem.C.row(pin_row_(i - equalities_)).transpose();
    }
    column.array() *= scale_.head(n_).array();
    const double norm = column.norm();
    row_scale_(i) = norm > 0.0 ? 1.0 / norm : 0.0;
    column *= row_scale_(i);
  }
  null_space_.Factor(n_, rows);
  free_ = n_ - null_space_.rank();
}

// Makes Y = D Z L^-T with L L' = Z'DHDZ + rho I. False if H is not convex there.
bool QpWorkspace::FactorHessian(const DenseQpView& problem) {
  regularisation_ = 0.0;
  smallest_pivot_ = 1.0;
  if (free_ == 0) {
    return true;
  }
  auto basis = basis_.topLeftCorner(n_, free_);
  auto transposed = basis_transposed_.topLeftCorner(free_, n_);
  auto hessian = hessian_.topLeftCorner(free_, free_);
  auto factor = factor_.topLeftCorner(free_, free_);
  null_space_.WriteBasis(basis);
  basis.array().colwise() *= scale_.head(n_).array();
  transposed = basis.transpose();
  MultiplyBySparseTranspose(transposed, problem.H, hessian_basis_.topLeftCorner(free_, n_));
  MultiplyByTranspose(hessian_basis_.topLeftCorner(free_, n_), transposed, hessian);

  double size = hessian.diagonal().maxCoeff();
  if (!(size > kZeroCurvature)) {
    size = (scale_.head(n_).array() * problem.g.array()).abs().maxCoeff();
    size = size > 0.0 ? size : 1.0;
  }
  auto min_pivots = min_pivots_.head(free_);
  min_pivots = (kPivotShare * hessian.diagonal()).cwiseMax(kPivotFloor * size);
  factor = hessian;
  bool is_factored = FactorCholesky(factor, min_pivots);
  min_pivots.setZero();
  for (double share = kRegularisation; !is_factored && share <= kMaxRegularisation;
       share *= kRegularisationGrowth) {
    regularisation_ = share * size;
    factor = hessian;
    factor.diagonal().array() += regularisation_;
    min_pivots.setConstant(0.1 * regularisation_);
    is_factored = FactorCholesky(factor, min_pivots);
  }
  if (!is_factored) {
    return false;
  }
  smallest_pivot_ = factor.diagonal().minCoeff();
  DivideByTransposedFactor(factor, basis);
  transposed = basis.transpose();
  return true;
}

// Writes the reduced rows, each of norm 1, to the projection.
void QpWorkspace::ReduceRanges(const DenseQpView& problem) {
  projection_.Reset(free_, ranges_);
  auto reduced = range_rows_.topLeftCorner(free_, inequalities_);
  MultiplyBySparseTranspose(basis_transposed_.topLeftCorner(free_, n_), problem.C, reduced);
  auto squares = row_values_.head(inequalities_);
  squares.setZero();
  for (int j = 0; j < n_; ++j) {
    squares += (scale_(j) * problem.C.col(j)).cwiseAbs2();
  }
  auto normals = projection_.normals();
  for (int k = 0; k < ranges_; ++k) {
    const int row = range_row_(k);
    const double norm = reduced.col(row).norm();
    const double fixed_norm = kFixedShare * std::sqrt(squares(row)) / smallest_pivot_;
    range_norm_(k) = norm > fixed_norm ? norm : 0.0;
    if (range_norm_(k) > 0.0) {
      normals.col(k) = reduced.col(row) * (1.0 / norm);
    } else {
      normals.col(k).setZero();
    }
  }
}

}  // namespace sidestep::wbc::internal
