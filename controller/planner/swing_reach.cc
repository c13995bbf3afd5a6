// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/swing_reach.h"

#include <algorithm>

namespace sidestep {

void KeepWithinSwing(const std::vector<Eigen::Vector3d>& p_WF, double speed_mps, Tick tick,
                     double tick_s, ContactSchedule* schedule) {
  for (std::size_t foot = 0; foot < schedule->feet.size(); ++foot) {
    PlannedContact& next = schedule->feet[foot].front().contact;
    if (next.start_tick <= tick) continue;  // it stands
    const double far_m = speed_mps * SecondsAt(next.start_tick - tick, tick_s);
    const Eigen::Vector3d here_F = next.R_WF.transpose() * (p_WF[foot] - next.nominal_p_WF);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double lower_m = next.box_lower_m[axis], upper_m = next.box_upper_m[axis];
      next.box_lower_m[axis] = std::clamp(here_F[axis] - far_m, lower_m, upper_m);
      next.box_upper_m[axis] = std::clamp(here_F[axis] + far_m, lower_m, upper_m);
    }
  }
}

}  // namespace sidestep
