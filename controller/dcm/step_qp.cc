// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/step_qp.h"

#include <cmath>

namespace sidestep::dcm {
namespace {

// Variables: u and b from the stance foot, tau, s. Rows: u, tau; b - s, b + s; s.
constexpr Eigen::Index kStep = 0, kOffset = 2, kTau = 4, kSlack = 5, kVariables = 7;
constexpr Eigen::Index kStepRows = 0, kTauRow = 2, kBelowRows = 3, kAboveRows = 5, kSlackRows = 7,
                       kRows = 9;

}  // namespace

Eigen::Vector2d DcmAtTheEnd(const StepProblem& problem, double time_s) {
  const double growth = std::exp(problem.omega_per_s * (time_s - problem.elapsed_s));
  return problem.stance_m + growth * (problem.dcm_m - problem.stance_m);
}

StepDecision CapturePointStep(const StepProblem& problem) {
  StepDecision decision;
  decision.status = QpStatus::kSolved;
  decision.time_s = problem.nominal_s;
  const Eigen::Vector2d end_m = DcmAtTheEnd(problem, problem.nominal_s);
  decision.step_m = (end_m - problem.nominal_offset_m)
                        .cwiseMax(problem.least_step_m)
                        .cwiseMin(problem.most_step_m);
  decision.offset_m = end_m - decision.step_m;
  return decision;
}

StepQp::StepQp(const DcmParams& params)
    : params_(params), solver_({static_cast<int>(kVariables), 2, static_cast<int>(kRows)}) {
  qp_.H.setZero(kVariables, kVariables);
  qp_.g.setZero(kVariables);
  qp_.A.setZero(2, kVariables);
  qp_.b.setZero(2);
  qp_.C.setZero(kRows, kVariables);
  qp_.lower.setConstant(kRows, -wbc::kInfinity);
  qp_.upper.setConstant(kRows, wbc::kInfinity);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    qp_.H(kStep + axis, kStep + axis) = 2.0 * params.step_weight;
    qp_.H(kOffset + axis, kOffset + axis) = 2.0 * params.offset_weight;
    qp_.H(kSlack + axis, kSlack + axis) = 2.0 * params.viability_weight;
    qp_.A(axis, kStep + axis) = qp_.A(axis, kOffset + axis) = 1.0;
    qp_.C(kStepRows + axis, kStep + axis) = 1.0;
    qp_.C(kBelowRows + axis, kOffset + axis) = qp_.C(kAboveRows + axis, kOffset + axis) = 1.0;
    qp_.C(kBelowRows + axis, kSlack + axis) = -1.0;
    qp_.C(kAboveRows + axis, kSlack + axis) = 1.0;
    qp_.C(kSlackRows + axis, kSlack + axis) = 1.0;
    qp_.lower[kSlackRows + axis] = 0.0;
  }
  qp_.C(kTauRow, kTau) = 1.0;
}

void StepQp::Build(const StepProblem& problem) {
  const double omega = problem.omega_per_s;
  const double tau = std::exp(omega * problem.nominal_s);
  const double tau_weight = params_.time_weight / (omega * tau * omega * tau);
  const Eigen::Vector2d step_m = problem.nominal_step_m - problem.stance_m;
  qp_.H(kTau, kTau) = 2.0 * tau_weight;
  qp_.g.segment<2>(kStep) = -2.0 * params_.step_weight * step_m;
  qp_.g.segment<2>(kOffset) = -2.0 * params_.offset_weight * problem.nominal_offset_m;
  qp_.g[kTau] = -2.0 * tau_weight * tau;
  qp_.A.col(kTau) = -std::exp(-omega * problem.elapsed_s) * (problem.dcm_m - problem.stance_m);
  qp_.lower.segment<2>(kStepRows) = problem.least_step_m - problem.stance_m;
  qp_.upper.segment<2>(kStepRows) = problem.most_step_m - problem.stance_m;
  qp_.lower[kTauRow] = std::exp(omega * problem.least_s);
  qp_.upper[kTauRow] = std::exp(omega * problem.longest_s);
  qp_.upper.segment<2>(kBelowRows) = problem.most_offset_m;
  qp_.lower.segment<2>(kAboveRows) = problem.least_offset_m;
}

StepDecision StepQp::Solve(const StepProblem& problem) {
  Build(problem);
  const wbc::DenseQpSolution& solution = solver_.Solve(qp_);
  StepDecision decision;
  decision.status = solution.status;
  if (solution.status != QpStatus::kSolved) return decision;
  decision.step_m = problem.stance_m + solution.x.segment<2>(kStep);
  decision.offset_m = solution.x.segment<2>(kOffset);
  decision.time_s = std::log(solution.x[kTau]) / problem.omega_per_s;
  return decision;
}

}  // namespace sidestep::dcm
