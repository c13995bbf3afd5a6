// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// pose_step: the step that a schedule has next as a StepProblem of the pendulum.

#include <optional>

#include "controller/dcm/dcm_reference.h"
#include "controller/dcm/dcm_setup.h"
#include "controller/dcm/step_qp.h"

namespace sidestep::dcm {

/// The next step of a schedule, and its problem.
struct PosedStep {
  StepAhead step;
  PlannedContact contact;  ///< Of its foot, to come.
  StepProblem problem;
  /// Of the step's end after its landing: where the support might jump across, SwitchDelay_s().
  double delay_s{0.0};
  bool has_begun{false};  ///< The support that it ends is on; before that nothing is decided.
};

/// What the pendulum is asked of the step that `planner` has next at `now`; nothing if it has none.
/// T is counted from where the support might have jumped to the standing foot to where it might
/// jump to the next one: both SwitchDelay_s after a landing. The box is the contact's, times are
/// those of planner.timing, the nominal offset is the reference's, and the offset is bounded by the
/// widest, narrowest, farthest and quickest steps that the gait's boxes allow. The pressure is the
/// one that, held until the support's end, would let the nominal step do, as near to it as the
/// standing sole reaches. Does not allocate.
/// @param dcm_m  Of the belief.
std::optional<PosedStep> PoseStep(const DcmSetup& setup, const RobotState& state,
                                  const Eigen::Vector2d& dcm_m, const DcmReference& reference,
                                  const GaitPlanner& planner, Tick now);

}  // namespace sidestep::dcm
