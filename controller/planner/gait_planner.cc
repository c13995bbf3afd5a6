// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_planner.h"

#include <algorithm>
#include <utility>

#include "controller/planner/com_spline.h"

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
  if (params_.follow == FollowMode::kPath) return Eigen::Vector3d::Zero();
  if (sequence <= last_landing_) return shift_[static_cast<std::size_t>(sequence)];
  const Eigen::Vector3d& last = shift_[static_cast<std::size_t>(last_landing_)];
  const double distance_m = last.norm();
  const double back_m = params_.path_return_m * (sequence - last_landing_);
  return distance_m > back_m ? Eigen::Vector3d(last * (1.0 - back_m / distance_m))
                             : Eigen::Vector3d::Zero();
}

void GaitPlanner::NoteLandings(Tick tick) {
  for (std::size_t foot = 0; foot < gait_.feet.size(); ++foot) {
    auto& contacts = gait_.feet[foot];
    while (landed_[foot] < contacts.size() && contacts[landed_[foot]].contact.start_tick <= tick) {
      NominalContact& landed = contacts[landed_[foot]++];
      landed.landing_shift = Shift(landed.sequence);
      if (landed.decided) NoteFoothold(landed);
      last_landing_ = std::max(last_landing_, landed.sequence);
    }
  }
}

// The path moves with the foothold that was really taken.
void GaitPlanner::NoteFoothold(const NominalContact& landed) {
  Eigen::Vector3d& shift = shift_[static_cast<std::size_t>(landed.sequence)];
  shift = landed.contact.adjusted_p_WF - landed.contact.nominal_p_WF;
  shift.z() = 0.0;
}

const ContactPlan& GaitPlanner::Update(const RobotState& state, Tick tick) {
  NoteLandings(tick);
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
        NoteFoothold(nominal);
      }
      planned.push_back(nominal.contact);
      planned.back().nominal_p_WF += begun ? nominal.landing_shift : Shift(nominal.sequence);
      if (!begun && !nominal.decided) planned.back().adjusted_p_WF = planned.back().nominal_p_WF;
    }
  }
  return plan_;
}

void GaitPlanner::SetAdjusted(int foot, int index, const Eigen::Vector3d& p_WF) {
  NominalContact& nominal =
      gait_.feet[static_cast<std::size_t>(foot)][static_cast<std::size_t>(index)];
  nominal.contact.adjusted_p_WF = p_WF;
  nominal.decided = true;
}

ComReference GaitPlanner::KnotState(std::size_t at) const {
  const ComKnot& knot = gait_.com[at];
  ComReference state;
  state.p_WC = knot.p_WC + Shift(knot.sequence);
  if (knot.at_rest || at == 0 || at + 1 == gait_.com.size()) return state;
  const ComKnot& before = gait_.com[at - 1];
  const ComKnot& after = gait_.com[at + 1];
  state.v_WC = (after.p_WC + Shift(after.sequence) - before.p_WC - Shift(before.sequence)) /
               SecondsAt(after.tick - before.tick, tick_s_);
  return state;
}

ComReference GaitPlanner::ReferenceAt(Tick tick) const {
  const auto next =
      std::upper_bound(gait_.com.begin(), gait_.com.end(), tick,
                       [](Tick value, const ComKnot& knot) { return value < knot.tick; });
  if (next == gait_.com.begin()) return KnotState(0);
  if (next == gait_.com.end()) return KnotState(gait_.com.size() - 1);
  const auto at = static_cast<std::size_t>(next - gait_.com.begin());
  const Tick start = gait_.com[at - 1].tick;
  return QuinticAt(KnotState(at - 1), KnotState(at), SecondsAt(next->tick - start, tick_s_),
                   SecondsAt(tick - start, tick_s_));
}

}  // namespace sidestep
