// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/planner/com_spline.h"
#include "controller/planner/recovery.h"

namespace sidestep {

GaitPlanner::GaitPlanner(NominalGait gait, const PlannerParams& params, Tick horizon, double tick_s)
    : gait_(std::move(gait)),
      params_(params),
      horizon_(horizon),
      tick_s_(tick_s),
      first_(gait_.feet.size(), 0),
      landed_(gait_.feet.size(), 1) {
  int last_sequence = 0;
  for (const auto& contacts : gait_.feet) {
    for (const NominalContact& nominal : contacts) {
      last_sequence = std::max(last_sequence, nominal.sequence);
    }
  }
  shift_.assign(static_cast<std::size_t>(last_sequence) + 1, Eigen::Vector3d::Zero());
  plan_.feet.resize(gait_.feet.size());
  for (std::size_t foot = 0; foot < gait_.feet.size(); ++foot) {
    plan_.feet[foot].reserve(gait_.feet[foot].size());
  }
}

Eigen::Vector3d GaitPlanner::Shift(int sequence) const {
  if (params_.follow == FollowMode::kPath && !has_recovered_) return Eigen::Vector3d::Zero();
  if (sequence <= last_landing_) return shift_[static_cast<std::size_t>(sequence)];
  const Eigen::Vector3d& last = shift_[static_cast<std::size_t>(last_landing_)];
  const double distance_m = last.norm();
  const double back_m = params_.path_return_m * (sequence - last_landing_);
  return distance_m > back_m ? Eigen::Vector3d(last * (1.0 - back_m / distance_m))
                             : Eigen::Vector3d::Zero();
}

void GaitPlanner::NoteLandings(const RobotState& state, Tick tick) {
  for (std::size_t foot = 0; foot < gait_.feet.size(); ++foot) {
    auto& contacts = gait_.feet[foot];
    while (landed_[foot] < contacts.size() && contacts[landed_[foot]].contact.start_tick <= tick) {
      NominalContact& landed = contacts[landed_[foot]++];
      landed.landing_shift = Shift(landed.sequence);
      if (!landed.decided) landed.contact.adjusted_p_WF += landed.landing_shift;
      const bool goes_with_the_foot = params_.follow == FollowMode::kPath;
      shift_[static_cast<std::size_t>(landed.sequence)] =
          goes_with_the_foot ? Displacement(landed.contact) : CapturePointError(state, tick);
      last_landing_ = std::max(last_landing_, landed.sequence);
    }
  }
}

// How far from its nominal place a foot has landed.
Eigen::Vector3d GaitPlanner::Displacement(const PlannedContact& landed) {
  Eigen::Vector3d displacement = landed.adjusted_p_WF - landed.nominal_p_WF;
  displacement.z() = 0.0;
  return displacement;
}

Eigen::Vector3d GaitPlanner::CapturePointError(const RobotState& state, Tick tick) const {
  const ComReference nominal = Reference(tick, false);
  const double time_constant_s = PendulumTimeConstant_s(nominal.p_WC.z());
  Eigen::Vector3d error = state.p_WC - nominal.p_WC + time_constant_s * (state.v_WC - nominal.v_WC);
  error.z() = 0.0;
  return error;
}

void GaitPlanner::EnableRecovery(const RecoverySetup& setup) {
  constexpr std::size_t kKnotsOfAStep = 7;  // at most, with standing before and after
  recovery_ = setup;
  const RecoveryParams& params = params_.recovery;
  const Tick step = TickAt(params.swing_s + params.double_support_s, tick_s_);
  const auto more = static_cast<std::size_t>(setup.end_tick / step + params.steps + 1);
  gait_.com.reserve(gait_.com.size() + kKnotsOfAStep * more);
  shift_.reserve(shift_.size() + more);
  for (std::size_t foot = 0; foot < gait_.feet.size(); ++foot) {
    gait_.feet[foot].reserve(gait_.feet[foot].size() + more);
    plan_.feet[foot].reserve(gait_.feet[foot].size() + more);
  }
}

// Both feet on the ground, in the plan and by feel, and none of them about to leave it.
bool GaitPlanner::StandsForNow(const RobotState& state, Tick tick) const {
  for (std::size_t foot = 0; foot < gait_.feet.size(); ++foot) {
    const PlannedContact& contact = gait_.feet[foot][first_[foot]].contact;
    const bool stands = contact.start_tick <= tick && state.feet[foot].in_contact;
    if (!stands || contact.end_tick <= tick + 2 * recovery_->grid) return false;
  }
  return true;
}

void GaitPlanner::RecoverIfNeeded(const RobotState& state, Tick tick) {
  if (!recovery_ || tick % recovery_->grid != 0 || !StandsForNow(state, tick)) return;
  const Eigen::Vector2d capture_point = CapturePoint(state, recovery_->mass_kg);
  const Eigen::Vector2d middle = 0.5 * (state.feet[0].p_WF + state.feet[1].p_WF).head<2>();
  const Eigen::Vector2d ahead =
      capture_point + params_.recovery.margin_m * (capture_point - middle).normalized();
  if (DistanceFromSoles(ahead, state.feet, recovery_->vertices_m) == 0.0) return;
  // The foot that carries less is the one that can go.
  const double left_m = (capture_point - state.feet[0].p_WF.head<2>()).norm();
  const double right_m = (capture_point - state.feet[1].p_WF.head<2>()).norm();
  InsertRecovery(params_.recovery, left_m > right_m ? 0 : 1, recovery_->segments,
                 recovery_->geometry, tick, recovery_->end_tick, tick_s_, &gait_);
  has_recovered_ = true;
  int last_sequence = last_landing_;
  for (const auto& contacts : gait_.feet) {
    last_sequence = std::max(last_sequence, contacts.back().sequence);
  }
  shift_.resize(static_cast<std::size_t>(last_sequence) + 1, Eigen::Vector3d::Zero());
  shift_[static_cast<std::size_t>(last_landing_)] = CapturePointError(state, tick);
}

const ContactPlan& GaitPlanner::Update(const RobotState& state, Tick tick) {
  NoteLandings(state, tick);
  RecoverIfNeeded(state, tick);
  for (std::size_t foot = 0; foot < gait_.feet.size(); ++foot) {
    auto& contacts = gait_.feet[foot];
    while (first_[foot] + 1 < contacts.size() && contacts[first_[foot]].contact.end_tick <= tick) {
      ++first_[foot];
    }
    auto& planned = plan_.feet[foot];
    planned.clear();
    for (std::size_t at = first_[foot]; at < contacts.size(); ++at) {
      NominalContact& nominal = contacts[at];
      if (nominal.contact.start_tick > tick + horizon_ && !planned.empty()) break;
      if (nominal.contact.end_tick <= tick) continue;
      const bool begun = nominal.contact.start_tick <= tick;
      if (begun && state.feet[foot].in_contact) {
        nominal.contact.adjusted_p_WF = state.feet[foot].p_WF;
      }
      planned.push_back(nominal.contact);
      planned.back().nominal_p_WF += begun ? nominal.landing_shift : Shift(nominal.sequence);
      if (!begun && !nominal.decided) planned.back().adjusted_p_WF = planned.back().nominal_p_WF;
    }
  }
  KeepFeetApart(tick);
  return plan_;
}

// The next landing's box ends where its foot would come too close to the one that stands then.
void GaitPlanner::KeepFeetApart(Tick tick) {
  if (plan_.feet.size() != 2) return;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    for (PlannedContact& next : plan_.feet[foot]) {
      if (next.start_tick <= tick) continue;
      const PlannedContact* other = nullptr;
      for (const PlannedContact& contact : plan_.feet[1 - foot]) {
        if (contact.start_tick <= next.start_tick) other = &contact;
      }
      if (other == nullptr || other->start_tick > tick) continue;  // not decided yet
      const double y_m = (next.R_WF.transpose() * (other->adjusted_p_WF - next.nominal_p_WF)).y();
      if (foot == 0) {
        next.box_lower_m.y() = std::max(next.box_lower_m.y(), y_m + params_.min_step_width_m);
        next.box_upper_m.y() = std::max(next.box_upper_m.y(), next.box_lower_m.y());
      } else {
        next.box_upper_m.y() = std::min(next.box_upper_m.y(), y_m - params_.min_step_width_m);
        next.box_lower_m.y() = std::min(next.box_lower_m.y(), next.box_upper_m.y());
      }
      break;
    }
  }
}

void GaitPlanner::SetAdjusted(int foot, int index, const Eigen::Vector3d& p_WF) {
  auto& contacts = gait_.feet[static_cast<std::size_t>(foot)];
  if (static_cast<std::size_t>(index) >= contacts.size()) return;  // of a gait since rewritten
  NominalContact& nominal = contacts[static_cast<std::size_t>(index)];
  nominal.contact.adjusted_p_WF = p_WF;
  nominal.decided = true;
}

ComReference GaitPlanner::KnotState(std::size_t at, bool shifted) const {
  const auto place = [&](const ComKnot& knot) -> Eigen::Vector3d {
    return shifted ? Eigen::Vector3d(knot.p_WC + Shift(knot.sequence)) : knot.p_WC;
  };
  const ComKnot& knot = gait_.com[at];
  ComReference state;
  state.p_WC = place(knot);
  if (knot.at_rest || at == 0 || at + 1 == gait_.com.size()) return state;
  const ComKnot& before = gait_.com[at - 1];
  const ComKnot& after = gait_.com[at + 1];
  state.v_WC = (place(after) - place(before)) / SecondsAt(after.tick - before.tick, tick_s_);
  return state;
}

ComReference GaitPlanner::Reference(Tick tick, bool shifted) const {
  const auto next =
      std::upper_bound(gait_.com.begin(), gait_.com.end(), tick,
                       [](Tick value, const ComKnot& knot) { return value < knot.tick; });
  if (next == gait_.com.begin()) return KnotState(0, shifted);
  if (next == gait_.com.end()) return KnotState(gait_.com.size() - 1, shifted);
  const auto at = static_cast<std::size_t>(next - gait_.com.begin());
  const Tick start = gait_.com[at - 1].tick;
  return QuinticAt(KnotState(at - 1, shifted), KnotState(at, shifted),
                   SecondsAt(next->tick - start, tick_s_), SecondsAt(tick - start, tick_s_));
}

}  // namespace sidestep
