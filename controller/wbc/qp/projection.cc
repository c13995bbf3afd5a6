// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/qp/projection.h"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>

#include "controller/wbc/qp/dense_qp.h"

namespace sidestep::wbc::internal {

namespace {

// A unit normal whose part outside the active ones is shorter than this depends on them. Rounding
// in N reaches 1e-12 where the regularised Hessian is flat.
constexpr double kDependentNormal = 1e-10;

// Coefficients below this share of the largest are rounding.
constexpr double kCoefficientNoise = 1e-12;

// A gap in the infeasibility certificate counts if it exceeds this share of its terms.
constexpr double kProofNoise = 1e-11;

// Violations below this share of |y| are rounding in N' y.
constexpr double kValueNoise = 1e-14;

}  // namespace

Projection::Projection(int max_dimension, int max_rows)
    : normals_(max_dimension, max_rows),
      lower_(max_rows),
      upper_(max_rows),
      slack_(max_rows),
      y_(max_dimension),
      values_(max_rows),
      q_(max_dimension, max_dimension),
      r_(max_dimension, max_dimension),
      rotated_target_(max_dimension),
      row_(max_dimension),
      sign_(max_dimension),
      multiplier_(max_dimension),
      rotated_(max_dimension),
      coefficients_(max_dimension),
      buffer_(max_dimension),
      is_skipped_(max_rows) {}

void Projection::Reset(int dimension, int rows) {
  dimension_ = dimension;
  rows_ = rows;
  active_ = 0;
  q_.topLeftCorner(dimension, dimension).setIdentity();
  rotated_target_.head(dimension).setZero();
  is_skipped_.head(rows).setConstant(false);
}

void Projection::TryActivate(int row, Side side) {
  const double sign = side == Side::kLower ? 1.0 : -1.0;
  if (!is_skipped_(row) && std::isfinite(BoundOf(row, sign))) {
    rotated_.head(dimension_).noalias() =
        sign *
        (q_.topLeftCorner(dimension_, dimension_).transpose() * normals_.col(row).head(dimension_));
    if (Append(row, sign)) {
      multiplier_(active_ - 1) = 0.0;
    }
  }
}

// Adds the row whose rotated normal is in rotated_; false if it depends on the active ones.
bool Projection::Append(int row, double sign) {
  const int rest = dimension_ - active_;
  if (rest == 0) {
    return false;
  }
  auto tail = rotated_.segment(active_, rest);
  const double norm = tail.norm();
  if (!(norm > kDependentNormal)) {
    return false;
  }
  // Reflect the tail onto one axis, and the free columns of Q with it.
  const double beta = tail(0) > 0.0 ? -norm : norm;
  const double tau = (beta - tail(0)) / beta;
  tail.tail(rest - 1) *= 1.0 / (tail(0) - beta);
  tail(0) = 1.0;
  auto free_columns = q_.block(0, active_, dimension_, rest);
  auto product = buffer_.head(dimension_);
  product.noalias() = free_columns * tail;
  for (int j = 0; j < rest; ++j) {
    free_columns.col(j) -= (tau * tail(j)) * product;
  }
  auto target_tail = rotated_target_.segment(active_, rest);
  target_tail -= (tau * tail.dot(target_tail)) * tail;
  r_.col(active_).head(active_) = rotated_.head(active_);
  r_(active_, active_) = beta;
  row_(active_) = row;
  sign_(active_) = sign;
  is_skipped_(row) = true;
  ++active_;
  return true;
}

void Projection::Remove(int k) {
  is_skipped_(row_(k)) = false;
  --active_;
  for (int j = k; j < active_; ++j) {
    r_.col(j).head(j + 2) = r_.col(j + 1).head(j + 2);
    row_(j) = row_(j + 1);
    sign_(j) = sign_(j + 1);
    multiplier_(j) = multiplier_(j + 1);
  }
  for (int j = k; j < active_; ++j) {
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(r_(j, j), r_(j + 1, j));
    r_.block(0, j, active_ + 1, active_ - j).applyOnTheLeft(j, j + 1, rotation.adjoint());
    q_.topRows(dimension_).applyOnTheRight(j, j + 1, rotation);
    rotated_target_.applyOnTheLeft(j, j + 1, rotation.adjoint());
  }
}

// Recomputes y and multipliers from the active set alone: no error builds up over the steps.
void Projection::SolveActiveSet() {
  const int rest = dimension_ - active_;
  const auto rotated_target = rotated_target_.head(dimension_);
  auto coordinates = rotated_.head(dimension_);
  coordinates.tail(rest) = rotated_target.tail(rest);
  for (int k = 0; k < active_; ++k) {
    const double known = r_.col(k).head(k).dot(coordinates.head(k));
    coordinates(k) = (BoundOf(row_(k), sign_(k)) - known) / r_(k, k);
  }
  y_.head(dimension_).noalias() = q_.topLeftCorner(dimension_, dimension_) * coordinates;
  auto remaining = coefficients_.head(active_);
  remaining = coordinates.head(active_) - rotated_target.head(active_);
  for (int k = active_ - 1; k >= 0; --k) {
    multiplier_(k) = remaining(k) / r_(k, k);
    remaining.head(k) -= multiplier_(k) * r_.col(k).head(k);
  }
}

void Projection::DropNegativeMultipliers() {
  SolveActiveSet();
  while (active_ > 0) {
    Eigen::Index worst = 0;
    if (multiplier_.head(active_).minCoeff(&worst) >= 0.0) {
      return;
    }
    Remove(static_cast<int>(worst));
    ++changes_;
    SolveActiveSet();
  }
}

// The inactive row farthest outside its bounds at values_, or -1.
int Projection::MostViolated() const {
  const double noise = kValueNoise * y_.head(dimension_).norm();
  double worst = 0.0;
  int worst_row = -1;
  for (int i = 0; i < rows_; ++i) {
    const double violation = std::max(lower_(i) - values_(i), values_(i) - upper_(i));
    if (violation > worst && !is_skipped_(i) && violation > std::max(slack_(i), noise)) {
      worst = violation;
      worst_row = i;
    }
  }
  return worst_row;
}

// Whether sign * normal = sum_k coefficients_(k) * (active normal k), no coefficient positive,
// makes the row's bound contradict the active ones by more than rounding.
bool Projection::IsProof(int row, double sign) const {
  double gap = BoundOf(row, sign);
  double terms = std::abs(gap);
  for (int k = 0; k < active_; ++k) {
    const double term = coefficients_(k) * BoundOf(row_(k), sign_(k));
    gap -= term;
    terms += std::abs(term);
  }
  return gap > kProofNoise * terms;
}

// One step of the dual method for a violated row: as far as the row's bound, or until an active
// multiplier would change sign; that one is dropped.
Projection::Step Projection::StepTowards(int row, double sign, double& new_multiplier) {
  const auto normal = normals_.col(row).head(dimension_);
  const int rest = dimension_ - active_;
  auto rotated = rotated_.head(dimension_);
  rotated.noalias() = sign * (q_.topLeftCorner(dimension_, dimension_).transpose() * normal);
  auto coefficients = coefficients_.head(active_);
  coefficients = rotated.head(active_);
  for (int k = active_ - 1; k >= 0; --k) {
    coefficients(k) /= r_(k, k);
    coefficients.head(k) -= coefficients(k) * r_.col(k).head(k);
  }
  const double noise =
      active_ > 0 ? kCoefficientNoise * (1.0 + coefficients.cwiseAbs().maxCoeff()) : 0.0;
  double dual_step = kInfinity;
  int blocking = -1;
  for (int k = 0; k < active_; ++k) {
    if (coefficients(k) > noise && multiplier_(k) < dual_step * coefficients(k)) {
      dual_step = multiplier_(k) / coefficients(k);
      blocking = k;
    }
  }
  const double free_norm_sq = rotated.tail(rest).squaredNorm();
  double primal_step = kInfinity;
  if (free_norm_sq > kDependentNormal * kDependentNormal) {
    const double violation = BoundOf(row, sign) - sign * normal.dot(y_.head(dimension_));
    primal_step = std::max(violation, 0.0) / free_norm_sq;
  } else if (blocking < 0) {
    return IsProof(row, sign) ? Step::kEmpty : Step::kIgnored;
  }
  const double step = std::min(dual_step, primal_step);
  multiplier_.head(active_) -= step * coefficients;
  new_multiplier += step;
  if (primal_step <= dual_step) {  // y is recomputed with the row active
    return Append(row, sign) ? Step::kFull : Step::kIgnored;
  }
  if (std::isfinite(primal_step)) {
    y_.head(dimension_).noalias() +=
        step * (q_.block(0, active_, dimension_, rest) * rotated.tail(rest));
  }
  Remove(blocking);
  return Step::kDropped;
}

ProjectionStatus Projection::Enforce(int row, int max_changes) {
  const double sign = values_(row) < lower_(row) ? 1.0 : -1.0;
  double new_multiplier = 0.0;
  while (changes_ < max_changes) {
    ++changes_;
    switch (StepTowards(row, sign, new_multiplier)) {
      case Step::kDropped:
        break;
      case Step::kEmpty:
        return ProjectionStatus::kEmpty;
      case Step::kIgnored:
        is_skipped_(row) = true;
        DropNegativeMultipliers();
        return ProjectionStatus::kSolved;
      case Step::kFull:
        SolveActiveSet();
        // What exact arithmetic keeps at or above zero.
        multiplier_.head(active_) = multiplier_.head(active_).cwiseMax(0.0);
        return ProjectionStatus::kSolved;
    }
  }
  return ProjectionStatus::kIterationLimit;
}

ProjectionStatus Projection::Solve(const ConstVectorRef& target, int max_changes) {
  changes_ = 0;
  rotated_target_.head(dimension_).noalias() =
      q_.topLeftCorner(dimension_, dimension_).transpose() * target;
  is_skipped_.head(rows_).setConstant(false);
  for (int k = 0; k < active_; ++k) {
    is_skipped_(row_(k)) = true;
  }
  DropNegativeMultipliers();
  while (true) {
    values_.head(rows_).noalias() = normals().transpose() * y_.head(dimension_);
    const int row = MostViolated();
    if (row < 0) {
      return ProjectionStatus::kSolved;
    }
    const ProjectionStatus status = Enforce(row, max_changes);
    if (status != ProjectionStatus::kSolved) {
      return status;
    }
  }
}

}  // namespace sidestep::wbc::internal
