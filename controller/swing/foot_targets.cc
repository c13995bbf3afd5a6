// SPDX-License-Identifier: BSD-3-Clause
#include "controller/swing/foot_targets.h"

#include "models/support/require.h"

namespace sidestep {

FootTargets::FootTargets(std::size_t num_feet, StandingRule rule, double tick_s,
                         const FloorSearch& search, const SwingLimits& limits)
    : rule_(rule),
      longest_dip_(TickAt(kLongestDip_s, tick_s)),
      feet_(num_feet, Foot{SwingFoot(tick_s, search, limits)}) {}

void FootTargets::Update(const RobotState& state, const ContactPlan& plan, Tick tick,
                         std::vector<FootTarget>* feet) {
  SIDESTEP_REQUIRE(feet->size() == feet_.size(), feet->size());
  double planned_N = 0.0;
  for (const FootTarget& foot : *feet) planned_N += foot.force_N.z();
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    FootTarget& target = (*feet)[i];
    const bool stood = target.planned_contact;
    target.contact = plan.feet[i].front();
    target.planned_contact = target.contact.start_tick <= tick;
    if (stood && !target.planned_contact) {
      feet_[i].has_landed = false;
      feet_[i].swing.LiftOff(target.contact.swing, state.feet[i].p_WF, tick);
    }
    const bool is_idle = planned_N > 0.0 && target.force_N.z() <= kIdleShare * planned_N;
    UpdateFoot(state.feet[i], is_idle, tick, &feet_[i], &target);
  }
}

void FootTargets::UpdateFoot(const FootState& state, bool is_idle, Tick tick, Foot* foot,
                             FootTarget* target) const {
  const bool is_down = rule_ == StandingRule::kAsScheduled || state.in_contact;
  if (target->planned_contact && is_down) {
    foot->has_landed = true;
    foot->felt_tick = tick;
  }
  const bool is_lost = tick > foot->felt_tick + longest_dip_ && !is_idle;
  target->supports = foot->has_landed && !is_lost;
  if (target->supports) {
    target->p_WF = target->contact.adjusted_p_WF;
    target->v_WF.setZero();
    target->a_WF.setZero();
    return;
  }
  if (foot->has_landed) {
    foot->swing.GoDown(target->contact.adjusted_p_WF, foot->felt_tick + longest_dip_, tick);
  } else {
    foot->swing.Update(target->contact.adjusted_p_WF, target->contact.due_tick, tick);
  }
  target->p_WF = foot->swing.position();
  target->v_WF = foot->swing.velocity();
  target->a_WF = foot->swing.acceleration();
}

}  // namespace sidestep
