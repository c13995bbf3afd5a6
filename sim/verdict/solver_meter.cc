// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/solver_meter.h"

#include <algorithm>

#include "sim/verdict/plan_log.h"

namespace sidestep {

void SolverMeter::Add(Tick tick, const ControlTick& control) {
  for (const FootTarget& foot : control.feet) {
    max_cone_violation_N_ = std::max(max_cone_violation_N_, ConeViolation_N(foot, friction_));
  }
  if (!control.wbc.ok) ++wbc_failures_;
  if (!control.mpc.ran) return;
  if (control.mpc.fell_back) ++fallbacks_;
  if (IsUsable(control.mpc.status)) {
    mpc_failures_in_a_row_ = 0;
    return;
  }
  ++mpc_failures_;
  if (++mpc_failures_in_a_row_ > kMostMpcFailuresInARow && !lost_tick_) {
    lost_tick_ = tick;
    lost_status_ = EnumName(control.mpc.status);
  }
}

}  // namespace sidestep
