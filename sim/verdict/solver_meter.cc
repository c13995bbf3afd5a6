// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/solver_meter.h"

#include <algorithm>

#include "sim/verdict/plan_log.h"

namespace sidestep {

double SolverCount::failure_ratio() const {
  return solves > 0 ? static_cast<double>(failures) / solves : 0.0;
}

void SolverCount::Add(bool is_solved) {
  ++solves;
  if (!is_solved) ++failures;
}

double SolverMeter::max_failure_ratio() const {
  double ratio = 0.0;
  for (const SolverCount& count : counts_) ratio = std::max(ratio, count.failure_ratio());
  return ratio;
}

std::optional<Solver> SolverMeter::failing_solver() const {
  const auto failing = std::find_if(counts_.begin(), counts_.end(), [](const SolverCount& count) {
    return count.failures > kMostFailures && count.failure_ratio() > kMostFailureRatio;
  });
  if (failing == counts_.end()) return std::nullopt;
  return static_cast<Solver>(failing - counts_.begin());
}

void SolverMeter::Add(Tick tick, const ControlTick& control) {
  for (const FootTarget& foot : control.feet) {
    max_cone_violation_N_ = std::max(max_cone_violation_N_, ConeViolation_N(foot, friction_));
  }
  counts_[static_cast<std::size_t>(Solver::kWholeBody)].Add(control.wbc.ok);
  if (control.step.status != QpStatus::kNotSolved) {
    counts_[static_cast<std::size_t>(Solver::kStep)].Add(control.step.status == QpStatus::kSolved);
  }
  if (!control.mpc.ran) return;
  const bool is_usable = IsUsable(control.mpc.status);
  counts_[static_cast<std::size_t>(Solver::kMpc)].Add(is_usable);
  if (control.mpc.fell_back) ++fallbacks_;
  if (is_usable) {
    mpc_failures_in_a_row_ = 0;
    return;
  }
  if (++mpc_failures_in_a_row_ > kMostMpcFailuresInARow && !lost_tick_) {
    lost_tick_ = tick;
    lost_status_ = EnumName(control.mpc.status);
  }
}

}  // namespace sidestep
