// SPDX-License-Identifier: BSD-3-Clause
// What an iterate is worth, judged by the caller's data alone.
#include <algorithm>
#include <cmath>

#include "controller/wbc/qp/qp_workspace.h"

namespace sidestep::wbc::internal {

namespace {

// How well a ray must keep to H p = 0 and to the constraints to prove the problem unbounded.
constexpr double kRayTolerance = 1e-8;

}  // namespace

double QpWorkspace::EqualityViolation(const DenseQpView& problem) {
  auto errors = row_buffer_.head(equalities_);
  errors.noalias() = problem.A * solution_.x;
  double worst = 0.0;
  for (int i = 0; i < equalities_; ++i) {
    worst = std::max(worst, std::abs(errors(i) - problem.b(i)) / (1.0 + std::abs(problem.b(i))));
  }
  for (int k = 0; k < pins_; ++k) {
    const double value = pin_value(problem, pin_row_(k));
    const double error = problem.C.row(pin_row_(k)).dot(solution_.x) - value;
    worst = std::max(worst, std::abs(error) / (1.0 + std::abs(value)));
  }
  return worst;
}

// Fills in the three residuals from the caller's data; true if all are within tolerance.
bool QpWorkspace::ComputeResiduals(const DenseQpView& problem) {
  const auto& x = solution_.x;
  const auto& lambda = solution_.inequality_multipliers;
  auto sum = gradient_.head(n_);
  auto term = n_buffer_.head(n_);
  auto largest = n_buffer_2_.head(n_);
  sum.noalias() = problem.H * x;
  const double cost_size = 1.0 + std::abs(x.dot(sum)) + std::abs(problem.g.dot(x));
  largest = sum.cwiseAbs().cwiseMax(problem.g.cwiseAbs());
  sum += problem.g;
  term.noalias() = problem.A.transpose() * solution_.equality_multipliers;
  largest = largest.cwiseMax(term.cwiseAbs());
  sum += term;
  term.noalias() = problem.C.transpose() * lambda;
  largest = largest.cwiseMax(term.cwiseAbs());
  sum += term;
  solution_.dual_residual = (sum.array().abs() / (1.0 + largest.array())).maxCoeff();

  double primal = EqualityViolation(problem);
  double complementarity = 0.0;
  auto values = row_values_.head(inequalities_);
  values.noalias() = problem.C * x;
  for (int i = 0; i < inequalities_; ++i) {
    const double below = problem.lower(i) - values(i);
    const double above = values(i) - problem.upper(i);
    if (below > 0.0) {
      primal = std::max(primal, below / (1.0 + std::abs(problem.lower(i))));
    }
    if (above > 0.0) {
      primal = std::max(primal, above / (1.0 + std::abs(problem.upper(i))));
    }
    if (lambda(i) != 0.0) {
      complementarity =
          std::max(complementarity, std::abs(lambda(i) * (lambda(i) > 0.0 ? above : below)));
    }
  }
  solution_.primal_residual = primal;
  solution_.complementarity = complementarity / cost_size;
  // Written so that NaN is not "within tolerance".
  return solution_.primal_residual <= options_.tolerance &&
         solution_.dual_residual <= options_.tolerance &&
         solution_.complementarity <= options_.tolerance;
}

// Whether the last step is a direction along which the cost falls for ever.
bool QpWorkspace::IsUnboundedRay(const DenseQpView& problem) {
  auto ray = step_.head(n_);
  const double length = (ray.array() / scale_.head(n_).array()).abs().maxCoeff();
  if (!(length > 0.0)) {
    return false;
  }
  ray *= 1.0 / length;
  auto product = n_buffer_.head(n_);
  product.noalias() = problem.H * ray;
  const double curvature = (product.array() * scale_.head(n_).array()).abs().maxCoeff();
  const double slope = problem.g.dot(ray);
  const double slope_size = (problem.g.array() * scale_.head(n_).array()).abs().maxCoeff();
  if (curvature > kRayTolerance || slope > -kRayTolerance * slope_size || slope == 0.0) {
    return false;
  }
  auto values = row_values_.head(inequalities_);
  values.noalias() = problem.C * ray;
  for (int k = 0; k < ranges_; ++k) {
    const int row = range_row_(k);
    const double size =
        kRayTolerance *
        (problem.C.row(row).transpose().array() * scale_.head(n_).array()).matrix().norm();
    if ((std::isfinite(problem.upper(row)) && values(row) > size) ||
        (std::isfinite(problem.lower(row)) && values(row) < -size)) {
      return false;
    }
  }
  return true;
}

}  // namespace sidestep::wbc::internal
