// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/qp/qp_workspace.h"

#include <algorithm>
#include <cmath>

namespace sidestep::wbc::internal {

namespace {

// Share of the tolerance that the projection may leave as violation; the rest is for rounding.
constexpr double kProjectionShare = 0.1;

}  // namespace

QpWorkspace::QpWorkspace(const DenseQpDimensions& maxima, const DenseQpOptions& options)
    : maxima_(maxima),
      options_(options),
      null_space_(maxima.variables, maxima.equalities + maxima.inequalities),
      projection_(maxima.variables, maxima.inequalities),
      pin_row_(maxima.inequalities),
      range_row_(maxima.inequalities),
      guess_side_(maxima.inequalities),
      scale_(maxima.variables),
      row_scale_(maxima.equalities + maxima.inequalities),
      range_norm_(maxima.inequalities),
      basis_(maxima.variables, maxima.variables),
      basis_transposed_(maxima.variables, maxima.variables),
      hessian_basis_(maxima.variables, maxima.variables),
      hessian_(maxima.variables, maxima.variables),
      factor_(maxima.variables, maxima.variables),
      min_pivots_(maxima.variables),
      range_rows_(maxima.variables, maxima.inequalities),
      gradient_(maxima.variables),
      step_(maxima.variables),
      n_buffer_(maxima.variables),
      n_buffer_2_(maxima.variables),
      row_values_(maxima.inequalities),
      row_buffer_(maxima.equalities),
      equality_buffer_(maxima.equalities + maxima.inequalities),
      target_(maxima.variables) {}

const DenseQpSolution& QpWorkspace::Solve(const DenseQpView& problem,
                                          const DenseQpSolution* guess) {
  Start(problem, guess);
  solution_.status = Reduce(problem);
  if (solution_.status == QpStatus::kNotSolved) {
    solution_.status = RunPasses(problem);
  }
  if (!solution_.x.allFinite()) {
    solution_.status = QpStatus::kNumericalError;
  }
  if (solution_.status != QpStatus::kSolved && solution_.status != QpStatus::kIterationLimit) {
    solution_.x.setZero();
    solution_.equality_multipliers.setZero();
    solution_.inequality_multipliers.setZero();
  }
  return solution_;
}

void QpWorkspace::Start(const DenseQpView& problem, const DenseQpSolution* guess) {
  n_ = static_cast<int>(problem.H.rows());
  equalities_ = static_cast<int>(problem.b.size());
  inequalities_ = static_cast<int>(problem.lower.size());
  guess_side_.setZero();
  // Before the answer is cleared: the guess may be that very object.
  if (guess != nullptr && guess->inequality_multipliers.size() == inequalities_) {
    for (int i = 0; i < inequalities_; ++i) {
      const double multiplier = guess->inequality_multipliers(i);
      guess_side_(i) = multiplier > 0.0 ? 1 : (multiplier < 0.0 ? -1 : 0);
    }
  }
  solution_.status = QpStatus::kNotSolved;
  solution_.x.setZero(n_);
  solution_.equality_multipliers.setZero(equalities_);
  solution_.inequality_multipliers.setZero(inequalities_);
  solution_.primal_residual = kInfinity;
  solution_.dual_residual = kInfinity;
  solution_.complementarity = kInfinity;
  solution_.iterations = 0;
  solution_.passes = 0;
}

QpStatus QpWorkspace::Reduce(const DenseQpView& problem) {
  if (!IsFinite(problem.H) || !IsFinite(problem.g) || !IsFinite(problem.A) ||
      !IsFinite(problem.b) || !IsFinite(problem.C)) {
    return QpStatus::kNumericalError;
  }
  const QpStatus status = ClassifyRows(problem);
  if (status != QpStatus::kNotSolved) {
    return status;
  }
  ComputeScales(problem);
  FactorEqualities(problem);
  if (!FactorHessian(problem)) {
    return QpStatus::kNumericalError;
  }
  ReduceRanges(problem);
  return QpStatus::kNotSolved;
}

QpStatus QpWorkspace::RunPasses(const DenseQpView& problem) {
  while (solution_.passes < options_.max_passes) {
    const bool is_first = solution_.passes++ == 0;
    CorrectEqualities(problem);
    if (is_first && EqualityViolation(problem) > options_.tolerance) {
      CorrectEqualities(problem);
      if (EqualityViolation(problem) > options_.tolerance) {
        return QpStatus::kInfeasible;
      }
    }
    if (!SetProjection(problem)) {
      return QpStatus::kInfeasible;
    }
    if (is_first) {
      ActivateGuess();
    }
    const ProjectionStatus status =
        projection_.Solve(target_.head(free_), options_.max_iterations - solution_.iterations);
    solution_.iterations += projection_.changes();
    if (status == ProjectionStatus::kEmpty) {
      return QpStatus::kInfeasible;
    }
    step_.head(n_).noalias() = basis_.topLeftCorner(n_, free_) * projection_.y();
    solution_.x += step_.head(n_);
    ReadMultipliers(problem);
    if (ComputeResiduals(problem)) {
      return QpStatus::kSolved;
    }
    if (status == ProjectionStatus::kIterationLimit || !solution_.x.allFinite()) {
      break;
    }
    if (regularisation_ > 0.0 && IsUnboundedRay(problem)) {
      return QpStatus::kUnbounded;
    }
  }
  return QpStatus::kIterationLimit;
}

// Moves x by the smallest (scaled) step onto the equalities.
void QpWorkspace::CorrectEqualities(const DenseQpView& problem) {
  auto errors = equality_buffer_.head(equalities_ + pins_);
  errors.head(equalities_).noalias() = problem.b - problem.A * solution_.x;
  for (int k = 0; k < pins_; ++k) {
    errors(equalities_ + k) =
        pin_value(problem, pin_row_(k)) - problem.C.row(pin_row_(k)).dot(solution_.x);
  }
  errors.array() *= row_scale_.head(equalities_ + pins_).array();
  null_space_.SolveSmallest(errors, n_buffer_.head(n_));
  solution_.x.array() += scale_.head(n_).array() * n_buffer_.head(n_).array();
}

// Bounds and target of the projection seen from the present x. False if a row that the equalities
// fix is outside its bounds.
bool QpWorkspace::SetProjection(const DenseQpView& problem) {
  gradient_.head(n_).noalias() = problem.H * solution_.x;
  gradient_.head(n_) += problem.g;
  target_.head(free_).setZero();
  target_.head(free_).noalias() -= basis_transposed_.topLeftCorner(free_, n_) * gradient_.head(n_);
  auto values = row_values_.head(inequalities_);
  values.noalias() = problem.C * solution_.x;
  for (int k = 0; k < ranges_; ++k) {
    const int row = range_row_(k);
    const double lower = problem.lower(row);
    const double upper = problem.upper(row);
    const double size = 1.0 + std::min(std::abs(lower), std::abs(upper));
    if (range_norm_(k) == 0.0) {
      const double violation = std::max(lower - values(row), values(row) - upper);
      if (violation > options_.tolerance * size) {
        return false;
      }
      projection_.lower()(k) = -kInfinity;
      projection_.upper()(k) = kInfinity;
      continue;
    }
    projection_.lower()(k) = (lower - values(row)) / range_norm_(k);
    projection_.upper()(k) = (upper - values(row)) / range_norm_(k);
    projection_.slack()(k) = kProjectionShare * options_.tolerance * size / range_norm_(k);
  }
  return true;
}

void QpWorkspace::ActivateGuess() {
  for (int k = 0; k < ranges_; ++k) {
    const int side = guess_side_(range_row_(k));
    if (side != 0) {
      projection_.TryActivate(k, side > 0 ? Side::kUpper : Side::kLower);
    }
  }
}

// lambda from the active rows, then nu (and lambda of pins) from what is left of the gradient.
void QpWorkspace::ReadMultipliers(const DenseQpView& problem) {
  auto& lambda = solution_.inequality_multipliers;
  lambda.setZero();
  for (int k = 0; k < projection_.active_count(); ++k) {
    const int range = projection_.active_row(k);
    lambda(range_row_(range)) = projection_.signed_multiplier(k) / range_norm_(range);
  }
  auto remaining = n_buffer_.head(n_);
  remaining = -problem.g;
  remaining.noalias() -= problem.H * solution_.x;
  remaining.noalias() -= problem.C.transpose() * lambda;
  remaining.array() *= scale_.head(n_).array();
  auto nu = equality_buffer_.head(equalities_ + pins_);
  null_space_.SolveMultipliers(remaining, nu);
  nu.array() *= row_scale_.head(equalities_ + pins_).array();
  solution_.equality_multipliers = nu.head(equalities_);
  for (int k = 0; k < pins_; ++k) {
    lambda(pin_row_(k)) = nu(equalities_ + k);
  }
}

}  // namespace sidestep::wbc::internal
