// SPDX-License-Identifier: BSD-3-Clause
#include "controller/swing/foot_targets.h"

#include <utility>

#include "models/support/require.h"

namespace sidestep {

FootTargets::FootTargets(std::size_t num_feet, std::vector<GaitParams> gait, StandingRule rule,
                         double tick_s)
    : gait_(std::move(gait)),
      rule_(rule),
      tick_s_(tick_s),
      swing_(num_feet, SwingFoot(SwingShape{}, tick_s)) {
  SIDESTEP_REQUIRE(!gait_.empty(), gait_.size());
}

void FootTargets::Update(const RobotState& state, const ContactPlan& plan, Tick tick,
                         std::vector<FootTarget>* feet) {
  SIDESTEP_REQUIRE(feet->size() == swing_.size(), feet->size());
  for (std::size_t i = 0; i < swing_.size(); ++i) {
    FootTarget& target = (*feet)[i];
    const bool stood = target.planned_contact;
    target.contact = plan.feet[i].front();
    target.planned_contact = target.contact.start_tick <= tick;
    if (stood && !target.planned_contact) {
      swing_[i].set_shape(ShapeAt(tick));
      swing_[i].LiftOff(state.feet[i].p_WF, tick);
    }
    UpdateFoot(state.feet[i], tick, &swing_[i], &target);
  }
}

void FootTargets::UpdateFoot(const FootState& state, Tick tick, SwingFoot* swing,
                             FootTarget* target) const {
  const bool is_down = rule_ == StandingRule::kAsScheduled || state.in_contact;
  if (target->planned_contact && is_down) {
    target->p_WF = target->contact.adjusted_p_WF;
    target->v_WF.setZero();
    target->a_WF.setZero();
    return;
  }
  swing->Update(target->contact.adjusted_p_WF, target->contact.start_tick, tick);
  target->p_WF = swing->position();
  target->v_WF = swing->velocity();
  target->a_WF = swing->acceleration();
}

SwingShape FootTargets::ShapeAt(Tick tick) const {
  const GaitParams* gait = &gait_.front();
  for (const GaitParams& segment : gait_) {
    if (TickAt(segment.start_s, tick_s_) <= tick) gait = &segment;
  }
  return {gait->swing_height_m, gait->landing_speed_mps};
}

}  // namespace sidestep
