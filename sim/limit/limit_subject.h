// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// limit_subject: the pendulum that a scenario's robot and gait come to.

#include "controller/types/gait_params.h"
#include "sim/limit/limit_params.h"
#include "sim/scenario/scenario.h"

namespace sidestep::limit {

/// What is pushed.
struct LimitSubject {
  LimitParams params;
  GaitType gait{GaitType::kWalk};
  bool is_planar{false};  ///< The base moves in a plane: nothing happens sideways.
};

/// The robot of `scenario` in the gait of the scenario's first push or, without one, in its last
/// gait that is no stand.
///
/// Soles and where they like the centre of pressure are robot.yaml's; so is the CoM's height. How
/// far a step gets is the legs' length times control.mpc.leg_stretch, hips at their height and
/// midway between the feet; without a model it is the MPC's box about the gait's foothold. Feet
/// come no nearer than control.planner.min_step_width_m or, if that is 0, than two soles 2 cm
/// apart. Times and speed are the planner's; one that is not told is 2 m/s.
/// @throws ConfigError for what this knows no limit of: a run, a walk sideways, a stand on one
/// foot.
LimitSubject LimitSubjectOf(const Scenario& scenario);

}  // namespace sidestep::limit
