// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/contact_schedule.h"

#include <algorithm>

#include "controller/planner/com_spline.h"

namespace sidestep {
namespace {

ComReference KnotState(const std::vector<ComKnot>& com, std::size_t at, double tick_s) {
  const ComKnot& knot = com[at];
  ComReference state;
  state.p_WC = knot.p_WC;
  state.a_WC = knot.a_WC;
  if (knot.at_rest || at == 0 || at + 1 == com.size()) return state;
  const ComKnot& before = com[at - 1];
  const ComKnot& after = com[at + 1];
  state.v_WC = (after.p_WC - before.p_WC) / SecondsAt(after.tick - before.tick, tick_s);
  state.v_WC.y() *= knot.haste;
  return state;
}

}  // namespace

ComReference NominalComAt(const ContactSchedule& schedule, Tick tick, double tick_s) {
  const std::vector<ComKnot>& com = schedule.com;
  const auto next =
      std::upper_bound(com.begin(), com.end(), tick,
                       [](Tick value, const ComKnot& knot) { return value < knot.tick; });
  if (next == com.begin()) return KnotState(com, 0, tick_s);
  if (next == com.end()) return KnotState(com, com.size() - 1, tick_s);
  const auto at = static_cast<std::size_t>(next - com.begin());
  const Tick start = com[at - 1].tick;
  return QuinticAt(KnotState(com, at - 1, tick_s), KnotState(com, at, tick_s),
                   SecondsAt(next->tick - start, tick_s), SecondsAt(tick - start, tick_s));
}

}  // namespace sidestep
