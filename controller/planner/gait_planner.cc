// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_planner.h"

#include <algorithm>

#include "controller/planner/capture_point.h"
#include "controller/planner/gait_generator.h"
#include "controller/planner/step_width.h"

namespace sidestep {
namespace {

const NominalContact* Find(const std::vector<NominalContact>& contacts, int index) {
  const auto at = std::find_if(contacts.begin(), contacts.end(), [index](const NominalContact& c) {
    return c.contact.index == index;
  });
  return at != contacts.end() ? &*at : nullptr;
}

}  // namespace

GaitPlanner::GaitPlanner(const GaitSetup& setup, const PlannerParams& params, Tick horizon,
                         const TouchDownRule& touch_downs)
    : setup_(setup),
      params_(params),
      horizon_(horizon),
      touch_downs_(touch_downs),
      support_(StandingSupport(setup)) {
  decided_.resize(static_cast<std::size_t>(setup.geometry.num_feet));
  moving_.resize(decided_.size());
  plan_.feet.resize(decided_.size());
  LayOutPlan();
}

const ContactPlan& GaitPlanner::Update(const RobotState& state, Tick tick) {
  tick_ = tick;
  const auto moved = AfterTouchDownEvent(setup_, support_, state, tick, touch_downs_);
  if (moved) support_ = *moved;
  has_landed_early_ = moved && NextSupport(setup_, support_)->tick == tick;
  const auto held = AfterHeldLiftOff(setup_, support_, state, tick, touch_downs_);
  if (held) support_ = *held;
  TakeLandings(state);
  NoteFeltFeet(state);
  LayOutPlan();
  return plan_;
}

void GaitPlanner::TakeLandings(const RobotState& state) {
  auto next = NextSupport(setup_, support_);
  while (next && next->tick <= tick_) {
    Land(&*next);
    const bool has_landed = next->sequence > support_.sequence;
    support_ = *next;
    if (has_landed && params_.follow == FollowMode::kCapturePoint) {
      GenerateSchedule(setup_, support_, tick_, horizon_, &schedule_);
      support_.shift = CapturePointError(state, NominalComAt(schedule_, tick_, setup_.tick_s),
                                         setup_.geometry.com_height_m);
    }
    next = NextSupport(setup_, support_);
  }
}

// Attaches what is known of the foot that lands to its contact in `next`.
void GaitPlanner::Land(GaitSupport* next) {
  for (std::size_t foot = 0; foot < decided_.size(); ++foot) {
    NominalContact& landed = next->feet[foot].nominal;
    const int index = landed.contact.index;
    if (index == support_.feet[foot].nominal.contact.index) continue;
    landed.shift = ShiftOf(support_, landed.sequence);
    landed.contact.adjusted_p_WF = landed.contact.nominal_p_WF + landed.shift;
    if (const Decision* decision = DecisionOn(foot, index)) {
      landed.contact.adjusted_p_WF = decision->p_WF;
    }
    std::erase_if(decided_[foot], [index](const Decision& d) { return d.index <= index; });
  }
}

void GaitPlanner::NoteFeltFeet(const RobotState& state) {
  for (std::size_t foot = 0; foot < decided_.size(); ++foot) {
    moving_[foot] = {state.feet[foot].p_WF, state.feet[foot].v_WF};
    is_felt_[foot] = state.feet[foot].in_contact;
    if (is_felt_[foot]) support_.feet[foot].nominal.contact.adjusted_p_WF = state.feet[foot].p_WF;
  }
}

// How far landings of `sequence` are off the path. A landing to come has drifted back to it.
Eigen::Vector3d GaitPlanner::ShiftOf(const GaitSupport& support, int sequence) const {
  if (sequence == support.sequence) return support.shift;
  const double distance_m = support.shift.norm();
  const double back_m = params_.path_return_m * (sequence - support.sequence);
  return distance_m > back_m ? Eigen::Vector3d(support.shift * (1.0 - back_m / distance_m))
                             : Eigen::Vector3d::Zero();
}

void GaitPlanner::LayOut(const GaitSupport& support, ContactSchedule* schedule) const {
  GenerateSchedule(setup_, support, tick_, horizon_, schedule);
  for (ComKnot& knot : schedule->com) {
    knot.p_WC += knot.sequence < support.sequence ? knot.shift : ShiftOf(support, knot.sequence);
  }
  for (std::size_t foot = 0; foot < schedule->feet.size(); ++foot) {
    for (NominalContact& nominal : schedule->feet[foot]) {
      PlannedContact& contact = nominal.contact;
      const bool has_begun = contact.start_tick <= tick_;
      contact.nominal_p_WF += has_begun ? nominal.shift : ShiftOf(support, nominal.sequence);
      if (has_begun) continue;
      const Decision* decision = DecisionOn(foot, contact.index);
      contact.adjusted_p_WF = decision != nullptr ? decision->p_WF : contact.nominal_p_WF;
    }
  }
  KeepFeetApart(params_.min_step_width_m, tick_, schedule);
  KeepWithinSwing(moving_, params_.swing, tick_, setup_.tick_s, schedule);
}

void GaitPlanner::LayOutPlan() {
  LayOut(support_, &schedule_);
  TakePlan(support_, schedule_, &plan_);
  for (std::size_t foot = 0; foot < schedule_.feet.size(); ++foot) {
    decided_[foot].reserve(schedule_.feet[foot].capacity());
  }
}

void GaitPlanner::TakePlan(const GaitSupport& support, const ContactSchedule& schedule,
                           ContactPlan* plan) {
  plan->grid_tick = support.tick;
  plan->feet.resize(schedule.feet.size());
  for (std::size_t foot = 0; foot < schedule.feet.size(); ++foot) {
    const auto& contacts = schedule.feet[foot];
    plan->feet[foot].reserve(contacts.capacity());
    plan->feet[foot].clear();
    for (const NominalContact& nominal : contacts) plan->feet[foot].push_back(nominal.contact);
  }
}

const GaitPlanner::Decision* GaitPlanner::DecisionOn(std::size_t foot, int index) const {
  for (const Decision& decision : decided_[foot]) {
    if (decision.index == index) return &decision;
  }
  return nullptr;
}

void GaitPlanner::AdoptFootholds(const std::vector<Foothold>& footholds) {
  for (const Foothold& foothold : footholds) Note(foothold);
  LayOutPlan();
}

void GaitPlanner::Note(const Foothold& foothold) {
  const auto at = static_cast<std::size_t>(foothold.foot);
  const NominalContact* nominal = Find(schedule_.feet[at], foothold.index);
  if (nominal == nullptr) return;
  if (nominal->contact.start_tick <= tick_) {
    if (!is_felt_[at]) support_.feet[at].nominal.contact.adjusted_p_WF = foothold.p_WF;
    return;
  }
  std::erase_if(decided_[at], [&](const Decision& d) { return d.index == foothold.index; });
  decided_[at].push_back({foothold.index, foothold.p_WF, nominal->contact.nominal_p_WF});
}

void GaitPlanner::Adopt(const GaitSupport& support) {
  for (std::size_t foot = 0; foot < decided_.size(); ++foot) {
    for (Decision& decision : decided_[foot]) {
      const NominalContact* nominal = Find(schedule_.feet[foot], decision.index);
      if (nominal != nullptr) decision.nominal_p_WF = nominal->contact.nominal_p_WF;
    }
  }
  support_ = support;
  LayOut(support_, &schedule_);
  for (std::size_t foot = 0; foot < decided_.size(); ++foot) {
    std::erase_if(decided_[foot], [&](const Decision& decision) {
      const NominalContact* nominal = Find(schedule_.feet[foot], decision.index);
      return nominal == nullptr || nominal->contact.nominal_p_WF != decision.nominal_p_WF;
    });
  }
  LayOutPlan();
}

}  // namespace sidestep
