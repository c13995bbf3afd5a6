// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/step_ahead.h"

#include "controller/planner/gait_writer.h"

namespace sidestep {

std::optional<StepAhead> StepAheadOf(const GaitSetup& setup, const GaitSupport& support) {
  GaitWriter writer(setup, support, nullptr);
  StepAhead step;
  step.gait = writer.NextGait();
  if (!writer.Step() || writer.support().sequence == support.sequence) return std::nullopt;
  const GaitSupport& after = writer.support();
  step.landing = after.tick;
  step.foot = after.feet[0].nominal.sequence == after.sequence ? 0 : 1;
  const auto at = static_cast<std::size_t>(step.foot);
  step.lift_off = writer.lift_off(step.foot).value_or(support.feet[at].nominal.contact.end_tick);
  return step;
}

}  // namespace sidestep
