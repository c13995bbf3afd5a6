// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/touch_down_events.h"

#include <algorithm>

#include "controller/planner/gait_writer.h"
#include "controller/planner/schedule_edits.h"

namespace sidestep {
namespace {

// The next landing as the schedule has it.
struct NextLanding {
  int foot{0};
  int sequence{0};
  Tick lift_off{0};
  Tick tick{0};
  Tick waited{0};
};

std::optional<NextLanding> NextLandingOf(const GaitSetup& setup, const GaitSupport& support) {
  GaitWriter writer(setup, support, nullptr);
  if (!writer.Step() || writer.support().sequence == support.sequence) return std::nullopt;
  const GaitSupport& after = writer.support();
  NextLanding landing;
  landing.foot = after.feet[0].nominal.sequence == after.sequence ? 0 : 1;
  const auto at = static_cast<std::size_t>(landing.foot);
  landing.sequence = after.sequence;
  landing.lift_off =
      writer.lift_off(landing.foot).value_or(support.feet[at].nominal.contact.end_tick);
  landing.tick = after.tick;
  landing.waited = after.tick - after.feet[at].nominal.contact.due_tick;
  return landing;
}

struct DueLiftOff {
  int foot{0};
  Tick tick{0};
};

// The lift-off of a foot that stands in `support` later than `after` and by `by`.
std::optional<DueLiftOff> LiftOffDueAt(const GaitSetup& setup, const GaitSupport& support,
                                       Tick after, Tick by) {
  GaitWriter writer(setup, support, nullptr);
  if (!writer.Step()) return std::nullopt;
  for (int foot = 0; foot < setup.geometry.num_feet; ++foot) {
    const std::optional<Tick> tick = writer.lift_off(foot);
    if (tick && *tick > after && *tick <= by) return DueLiftOff{foot, *tick};
  }
  return std::nullopt;
}

}  // namespace

std::optional<GaitSupport> AfterTouchDownEvent(const GaitSetup& setup, const GaitSupport& support,
                                               const RobotState& state, Tick tick,
                                               const TouchDownRule& rule) {
  if (!rule.is_felt) return std::nullopt;
  const std::optional<NextLanding> next = NextLandingOf(setup, support);
  if (!next) return std::nullopt;
  const FootState& foot = state.feet[static_cast<std::size_t>(next->foot)];
  TouchDownMove move{next->sequence};
  if (next->tick <= tick) {
    const Tick wait = tick + rule.period - next->tick;
    if (foot.in_contact || next->waited + wait > rule.longest_wait) return std::nullopt;
    move.by = move.waited = wait;
  } else {
    const Tick middle = next->lift_off + (next->tick - next->lift_off) / 2;
    if (tick < middle || foot.wrench.force_N.z() <= rule.early_load_N) return std::nullopt;
    move.by = tick - next->tick;
    move.waited = -std::min(next->waited, -move.by);
  }
  return MoveTouchDown(setup, support, tick - 1, move, 0);
}

std::optional<GaitSupport> AfterHeldLiftOff(const GaitSetup& setup, const GaitSupport& support,
                                            const RobotState& state, Tick tick,
                                            const TouchDownRule& rule) {
  if (!rule.is_felt || setup.geometry.num_feet != 2) return std::nullopt;
  const std::optional<DueLiftOff> due = LiftOffDueAt(setup, support, tick - rule.period, tick);
  if (!due) return std::nullopt;
  const auto carrying = static_cast<std::size_t>(1 - due->foot);
  const PlannedContact& contact = support.feet[carrying].nominal.contact;
  if (!support.feet[carrying].stands() || state.feet[carrying].in_contact) return std::nullopt;
  GaitSupport held = support;
  held.tick += tick + rule.period - due->tick;
  // The support began with the landing that is waited for, but for what it has been held.
  const bool is_over = held.tick - contact.start_tick > rule.longest_wait;
  if (is_over || held.tick > tick) return std::nullopt;
  // A segment that begins meanwhile may know no such lift-off.
  if (!LiftOffDueAt(setup, held, tick, tick + rule.period)) return std::nullopt;
  return held;
}

}  // namespace sidestep
