// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/swing_reach.h"

#include <algorithm>
#include <limits>

namespace sidestep {
namespace {

struct Reach {
  double least, most;  // m, along one axis
};

// Along one axis, from the foot's place and speed there. Where both bounds leave nothing, the one
// on speed decides: it is the foot's place that counts then.
Reach ReachOf(double p_m, double v_mps, double time_s, const SwingLimits& limits) {
  const double far_m =
      limits.speed_mps > 0.0 ? limits.speed_mps * time_s : std::numeric_limits<double>::infinity();
  const double drift_m = p_m + 0.5 * v_mps * time_s;
  const double round_m = limits.ReachIn(time_s);
  return {std::clamp(drift_m - round_m, p_m - far_m, p_m + far_m),
          std::clamp(drift_m + round_m, p_m - far_m, p_m + far_m)};
}

void Narrow(const MovingFoot& foot, double time_s, const SwingLimits& limits,
            PlannedContact* next) {
  const Eigen::Vector3d p_F = next->R_WF.transpose() * (foot.p_WF - next->nominal_p_WF);
  const Eigen::Vector3d v_F = next->R_WF.transpose() * foot.v_WF;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const Reach reach = ReachOf(p_F[axis], v_F[axis], time_s, limits);
    const double lower_m = next->box_lower_m[axis], upper_m = next->box_upper_m[axis];
    next->box_lower_m[axis] = std::clamp(reach.least, lower_m, upper_m);
    next->box_upper_m[axis] = std::clamp(reach.most, lower_m, upper_m);
  }
}

}  // namespace

void KeepWithinSwing(const std::vector<MovingFoot>& feet, const SwingLimits& limits, Tick tick,
                     double tick_s, ContactSchedule* schedule) {
  if (limits.speed_mps == 0.0 && limits.acceleration_mps2 == 0.0) return;
  for (std::size_t foot = 0; foot < schedule->feet.size(); ++foot) {
    auto& contacts = schedule->feet[foot];
    PlannedContact& first = contacts.front().contact;
    if (first.start_tick > tick) {
      Narrow(feet[foot], SecondsAt(first.start_tick - tick, tick_s), limits, &first);
    } else if (contacts.size() > 1) {
      PlannedContact& next = contacts[1].contact;
      const double swing_s = SecondsAt(next.start_tick - std::max(first.end_tick, tick), tick_s);
      Narrow({feet[foot].p_WF}, swing_s, limits, &next);
    }
  }
}

}  // namespace sidestep
