// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/qp/null_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sidestep::wbc::internal {

namespace {

// A row of norm 1 whose part outside the other rows is shorter than this counts as dependent.
// Kinematic redundancy (two feet) shows at 1e-15; the solver's own tolerance is 1e-9.
constexpr double kDependentNorm = 1e-10;

// Squared norms are downdated from 1; below this they have lost six digits and are recomputed.
constexpr double kRecomputeBelow = 1e-6;

}  // namespace

NullSpace::NullSpace(int max_variables, int max_rows)
    : factor_(max_variables, max_rows),
      taus_(std::min(max_variables, max_rows)),
      norms_sq_(max_rows),
      order_(max_rows),
      buffer_(std::max(max_variables, max_rows)) {}

void NullSpace::Swap(Eigen::Index a, Eigen::Index b) {
  if (a == b) {
    return;
  }
  factor_.col(a).head(variables_).swap(factor_.col(b).head(variables_));
  std::swap(norms_sq_(a), norms_sq_(b));
  std::swap(order_(a), order_(b));
}

void NullSpace::Factor(int variables, int rows) {
  variables_ = variables;
  rows_ = rows;
  rank_ = 0;
  for (int i = 0; i < rows; ++i) {
    order_(i) = i;
    norms_sq_(i) = factor_.col(i).head(variables).squaredNorm();
  }
  for (int k = 0; k < std::min(variables, rows); ++k) {
    Eigen::Index best = 0;
    norms_sq_.segment(k, rows - k).maxCoeff(&best);
    Swap(k, k + best);
    auto column = factor_.col(k).segment(k, variables - k);
    const double norm = column.norm();
    if (!(norm > kDependentNorm)) {
      return;
    }
    // Reflector onto -sign(head) * norm * e_1, scaled to a unit head.
    const double head = column(0);
    const double beta = head > 0.0 ? -norm : norm;
    taus_(k) = (beta - head) / beta;
    column.tail(variables - k - 1) *= 1.0 / (head - beta);
    column(0) = 1.0;
    const int rest = rows - k - 1;
    if (rest > 0) {
      auto trailing = factor_.block(k, k + 1, variables - k, rest);
      auto projections = buffer_.head(rest);
      projections.noalias() = trailing.transpose() * column;
      projections *= taus_(k);
      for (int j = 0; j < rest; ++j) {
        trailing.col(j) -= projections(j) * column;
        double& norm_sq = norms_sq_(k + 1 + j);
        norm_sq -= trailing(0, j) * trailing(0, j);
        if (norm_sq < kRecomputeBelow) {
          norm_sq = trailing.col(j).tail(variables - k - 1).squaredNorm();
        }
      }
    }
    column(0) = beta;
    rank_ = k + 1;
  }
}

void NullSpace::WriteBasis(MatrixRef basis) const {
  const int free = variables_ - rank_;
  basis.setZero();
  basis.bottomRows(free).setIdentity();
  for (int k = rank_ - 1; k >= 0; --k) {
    const int below = variables_ - k - 1;
    const auto tail = factor_.col(k).segment(k + 1, below);
    auto projections = buffer_.head(free);
    projections.noalias() = basis.bottomRows(below).transpose() * tail;
    projections *= taus_(k);
    // Row k is still zero: every later reflector starts below it.
    basis.row(k) = -projections.transpose();
    for (int j = 0; j < free; ++j) {
      basis.col(j).tail(below) -= projections(j) * tail;
    }
  }
}

void NullSpace::SolveSmallest(const ConstVectorRef& e, VectorRef x) const {
  x.setZero();
  for (int k = 0; k < rank_; ++k) {  // R' t = P' e
    const double known = factor_.col(k).head(k).dot(x.head(k));
    x(k) = (e(order_(k)) - known) / factor_(k, k);
  }
  for (int k = rank_ - 1; k >= 0; --k) {  // x = Q [t; 0]
    const int below = variables_ - k - 1;
    const auto tail = factor_.col(k).segment(k + 1, below);
    const double projection = taus_(k) * (x(k) + tail.dot(x.tail(below)));
    x(k) -= projection;
    x.tail(below) -= projection * tail;
  }
}

void NullSpace::SolveMultipliers(VectorRef v, VectorRef nu) const {
  for (int k = 0; k < rank_; ++k) {  // v := Q' v
    const int below = variables_ - k - 1;
    const auto tail = factor_.col(k).segment(k + 1, below);
    const double projection = taus_(k) * (v(k) + tail.dot(v.tail(below)));
    v(k) -= projection;
    v.tail(below) -= projection * tail;
  }
  nu.setZero();
  for (int k = rank_ - 1; k >= 0; --k) {  // R (P' nu) = v
    const double value = v(k) / factor_(k, k);
    v.head(k) -= value * factor_.col(k).head(k);
    nu(order_(k)) = value;
  }
}

}  // namespace sidestep::wbc::internal
