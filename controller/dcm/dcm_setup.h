// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// dcm_setup: what the parts of a DcmPlan know of the robot and of what is asked of it.

#include <Eigen/Core>
#include <vector>

#include "controller/types/control_params.h"

namespace sidestep::dcm {

/// The robot as a pendulum on two soles, and how it is to step.
struct DcmSetup {
  ControlParams control;     ///< stepping, dcm, planner.timing, the boxes and the least width.
  double com_height_m{0.5};  ///< Above the ground.
  double mass_kg{1.0};
  std::vector<Eigen::Matrix3Xd> vertices_m;  ///< Of each sole, in F.
  double tick_s{0.001};
};

}  // namespace sidestep::dcm
