// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/schedule_edits.h"

#include <algorithm>

#include "controller/planner/gait_writer.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr int kFarthestLanding = 16;  // bounds the time of a look-up

// The step or stand that `now` is in.
struct StepUnderWay {
  GaitParams gait;
  GaitSupport after;  // of a stand for good: with the knot at which it rests
  std::array<std::optional<Tick>, 2> lift_offs;
  bool all_stand{true};     // at now
  bool side_by_side{true};  // at its begin
};

bool HasLifted(const std::optional<Tick>& lift_off, Tick now) {
  return lift_off.has_value() && *lift_off <= now;
}

StepUnderWay StepAt(const GaitSetup& setup, const GaitSupport& support, Tick now) {
  SIDESTEP_REQUIRE(support.tick <= now, now - support.tick);
  GaitWriter writer(setup, support, nullptr);
  StepUnderWay step;
  step.gait = writer.NextGait();
  step.side_by_side = writer.FeetSideBySide();
  const bool goes_on = writer.Step();
  step.after = writer.support();
  SIDESTEP_REQUIRE(!goes_on || now < step.after.tick, now - step.after.tick);
  for (int foot = 0; foot < setup.geometry.num_feet; ++foot) {
    const auto at = static_cast<std::size_t>(foot);
    step.lift_offs[at] = writer.lift_off(foot);
    if (!support.feet[at].stands() || HasLifted(step.lift_offs[at], now)) step.all_stand = false;
  }
  return step;
}

// Where the step has got by `now`: feet that have lifted, knots that were passed.
GaitSupport Passed(const GaitSupport& support, const StepUnderWay& step, Tick now) {
  GaitSupport passed = support;
  for (std::size_t foot = 0; foot < step.lift_offs.size(); ++foot) {
    if (!HasLifted(step.lift_offs[foot], now)) continue;
    passed.feet[foot].nominal.contact.end_tick = *step.lift_offs[foot];
    passed.feet[foot].nominal.contact.end_is_known = true;
  }
  for (std::size_t i = 0; i < step.after.num_passed; ++i) {
    const ComKnot& knot = step.after.passed[i];
    if (knot.tick > passed.last_passed().tick && knot.tick <= now) passed.Pass(knot);
  }
  return passed;
}

// The same with all feet on the ground as a support of its own, from `now` on.
GaitSupport Held(const GaitSupport& support, const StepUnderWay& step, Tick now) {
  GaitSupport held = Passed(support, step, now);
  held.tick = now;
  held.orders.next = {};
  held.orders.moves = {};
  const bool rests = step.gait.type == GaitType::kStand && step.side_by_side;
  if (rests && held.last_passed().tick < now) {
    ComKnot rest = step.after.last_passed();  // where it stands
    rest.tick = now;
    held.Pass(rest);
  }
  return held;
}

// Lets the step under way be as `order` has it, in the time that it has, and nothing after it.
void LeaveToTheStep(const StepOrder& order, GaitSupport* support) {
  support->orders.next = {{order, {}}};
  for (TouchDownMove& move : support->orders.moves) {
    if (move.sequence != support->sequence + 1) move = {};
  }
}

// While a running robot is on one foot the other can close up instead, if it comes after now.
bool CanCloseARun(const GaitSetup& setup, const GaitSupport& support, const StepUnderWay& step,
                  Tick now) {
  const GaitSupport passed = Passed(support, step, now);
  const bool on_one_foot = passed.feet[0].stands() != passed.feet[1].stands();
  const Tick landing = support.tick + TickAt(step.gait.swing_s, setup.tick_s);
  return step.gait.type == GaitType::kRun && on_one_foot && landing > now;
}

GaitParams OnTheSpot(GaitParams gait) {
  gait.type = GaitType::kWalk;
  gait.step_length_m = 0.0;
  gait.step_side_m = 0.0;
  return gait;
}

// The foot that closes up to the one that landed last.
int FootBehind(const GaitSupport& support) {
  return support.feet[0].nominal.sequence < support.feet[1].nominal.sequence ? 0 : 1;
}

bool IsInTime(double step_s) { return step_s >= kShortestStep_s; }

bool CanBegin(const GaitSetup& setup, const GaitParams& gait, int first_foot) {
  const int num_feet = setup.geometry.num_feet;
  const bool is_for_the_feet =
      gait.type != GaitType::kStand && (gait.type == GaitType::kHop) == (num_feet == 1);
  const double step_s = gait.type == GaitType::kWalk ? gait.swing_s : gait.stance_s + gait.flight_s;
  return is_for_the_feet && IsInTime(step_s) && first_foot >= 0 && first_foot < num_feet;
}

// Adds `move` to the moves; false if there is no room.
bool AddMove(const TouchDownMove& move, GaitSupport* support) {
  TouchDownMove* free = nullptr;
  for (TouchDownMove& other : support->orders.moves) {
    if (other.sequence == move.sequence) {
      other.by += move.by;
      other.waited += move.waited;
      return true;
    }
    if (other.sequence <= support->sequence) free = &other;
  }
  if (free == nullptr) return false;
  *free = move;
  return true;
}

// Whether the landing that `writer` has just written from `before` can be at `touch_down` instead.
bool CanLandAt(Tick touch_down, const GaitWriter& writer, const GaitSupport& before, Tick now,
               Tick least_swing) {
  const GaitSupport& after = writer.support();
  const int foot = after.feet[0].nominal.sequence == after.sequence ? 0 : 1;
  const PlannedContact& left = before.feet[static_cast<std::size_t>(foot)].nominal.contact;
  const Tick lift_off = writer.lift_off(foot).value_or(left.end_tick);
  const Tick other_lift_off = writer.lift_off(1 - foot).value_or(touch_down);
  return touch_down > std::max(now, before.tick) && touch_down - lift_off >= least_swing &&
         touch_down >= other_lift_off;
}

}  // namespace

std::optional<GaitSupport> MoveTouchDown(const GaitSetup& setup, const GaitSupport& support,
                                         Tick now, const TouchDownMove& move, Tick least_swing) {
  StepAt(setup, support, now);  // checks now
  const int ahead = move.sequence - support.sequence;
  if (ahead <= 0 || ahead > kFarthestLanding) return std::nullopt;
  GaitSupport moved = support;
  if (!AddMove(move, &moved)) return std::nullopt;
  GaitSupport at = support;
  while (true) {
    GaitWriter writer(setup, at, nullptr);
    if (!writer.Step()) return std::nullopt;
    if (writer.support().sequence == move.sequence) {
      const Tick touch_down = writer.support().tick + move.by;
      if (!CanLandAt(touch_down, writer, at, now, least_swing)) return std::nullopt;
      return moved;
    }
    at = writer.support();
  }
}

GaitSupport StopNow(const GaitSetup& setup, const GaitSupport& support, Tick now) {
  const StepUnderWay step = StepAt(setup, support, now);
  const GaitParams closing = OnTheSpot(step.gait);
  GaitParams stand = closing;
  stand.type = GaitType::kStand;

  GaitSupport stop = support;
  if (step.gait.type == GaitType::kStand) {
    LeaveToTheStep({}, &stop);  // it stands, or closes its feet
  } else if (step.all_stand && step.side_by_side) {
    stop = Held(support, step, now);
  } else if (step.gait.type == GaitType::kWalk) {
    LeaveToTheStep({closing, 1, step.all_stand ? FootBehind(support) : -1}, &stop);
  } else if (step.all_stand) {
    stop = Held(support, step, now);
    stop.orders.next[0] = {closing, 1, FootBehind(support)};
  } else if (CanCloseARun(setup, support, step, now)) {
    stop = Passed(support, step, now);
    stop.orders.moves = {};
    stop.orders.next = {{{closing, 1, -1}, {}}};
  } else {
    LeaveToTheStep({step.gait, 1, -1}, &stop);
  }
  stop.orders.instead = stand;
  return stop;
}

std::optional<GaitSupport> StartNow(const GaitSetup& setup, const GaitSupport& support, Tick now,
                                    const GaitParams& gait, int first_foot) {
  const StepUnderWay step = StepAt(setup, support, now);
  const bool stands = step.gait.type == GaitType::kStand && step.side_by_side;
  if (!stands || !CanBegin(setup, gait, first_foot)) return std::nullopt;
  GaitSupport start = Held(support, step, now);
  start.previous = step.gait;
  start.next_foot = first_foot;
  start.orders.instead = gait;
  return start;
}

std::optional<GaitSupport> StepOnTheSpot(const GaitSetup& setup, const GaitSupport& support,
                                         Tick now, const RecoverySteps& recovery) {
  const bool can_step = setup.geometry.num_feet == 2 && recovery.steps > 0 &&
                        IsInTime(recovery.swing_s) && recovery.double_support_s >= 0.0 &&
                        (recovery.first_foot == 0 || recovery.first_foot == 1);
  const StepUnderWay step = StepAt(setup, support, now);
  if (!can_step) return std::nullopt;
  GaitParams gait = OnTheSpot(step.gait);
  gait.swing_s = recovery.swing_s;
  gait.double_support_s = recovery.double_support_s;
  const StepOrder steps{gait, recovery.steps, recovery.first_foot};
  if (step.all_stand) {
    GaitSupport stepping = Held(support, step, now);
    stepping.orders.next[0] = steps;
    return stepping;
  }
  const auto other = static_cast<std::size_t>(1 - recovery.first_foot);
  if (!step.after.feet[other].stands()) return std::nullopt;
  GaitSupport stepping = support;
  LeaveToTheStep({step.gait, 1, -1}, &stepping);
  stepping.orders.next[1] = steps;
  return stepping;
}

}  // namespace sidestep
