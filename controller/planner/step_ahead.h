// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// step_ahead: the step that a gait is in, or is to make next.

#include <optional>

#include "controller/planner/gait_setup.h"
#include "controller/planner/gait_support.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"

namespace sidestep {

/// From the lift-off of `foot` to its landing.
struct StepAhead {
  GaitParams gait;  ///< That asks for it; a stand's, of a step that closes up.
  int foot{0};
  Tick lift_off{0};  ///< Past, if the foot is in the air.
  Tick landing{0};
};

/// The step that ends the support. None where no landing does: it stands, for a time or for good.
std::optional<StepAhead> StepAheadOf(const GaitSetup& setup, const GaitSupport& support);

}  // namespace sidestep
