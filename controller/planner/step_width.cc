// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/step_width.h"

#include <algorithm>

namespace sidestep {
namespace {

// Where the other foot stands at `tick`, if that is known at `now`: it has landed already.
const PlannedContact* StandingAt(const std::vector<NominalContact>& contacts, Tick tick, Tick now) {
  const PlannedContact* other = nullptr;
  for (const NominalContact& nominal : contacts) {
    if (nominal.contact.start_tick <= tick) other = &nominal.contact;
  }
  return other != nullptr && other->start_tick <= now ? other : nullptr;
}

void ClipBox(int foot, const PlannedContact& other, double min_width_m, PlannedContact* next) {
  const double y_m = (next->R_WF.transpose() * (other.adjusted_p_WF - next->nominal_p_WF)).y();
  double& lower_m = next->box_lower_m.y();
  double& upper_m = next->box_upper_m.y();
  if (foot == 0) {
    lower_m = std::max(lower_m, y_m + min_width_m);
    upper_m = std::max(upper_m, lower_m);
  } else {
    upper_m = std::min(upper_m, y_m - min_width_m);
    lower_m = std::min(lower_m, upper_m);
  }
}

}  // namespace

void KeepFeetApart(double min_width_m, Tick tick, ContactSchedule* schedule) {
  if (schedule->feet.size() != 2) return;
  for (int foot = 0; foot < 2; ++foot) {
    for (NominalContact& nominal : schedule->feet[static_cast<std::size_t>(foot)]) {
      PlannedContact& next = nominal.contact;
      if (next.start_tick <= tick) continue;
      const auto& others = schedule->feet[static_cast<std::size_t>(1 - foot)];
      const PlannedContact* other = StandingAt(others, next.start_tick, tick);
      if (other == nullptr) continue;
      ClipBox(foot, *other, min_width_m, &next);
      break;
    }
  }
}

}  // namespace sidestep
