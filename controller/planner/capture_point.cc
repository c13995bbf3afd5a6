// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/capture_point.h"

#include <algorithm>
#include <cmath>

#include "models/support/gravity.h"

namespace sidestep {

double PendulumTimeConstant_s(double height_m) {
  return std::sqrt(std::max(height_m, 0.1) / kGravity_mps2);
}

Eigen::Vector3d CapturePointError(const RobotState& state, const ComReference& nominal,
                                  double height_m) {
  const double time_constant_s = PendulumTimeConstant_s(height_m);
  Eigen::Vector3d error = state.p_WC - nominal.p_WC + time_constant_s * (state.v_WC - nominal.v_WC);
  error.z() = 0.0;
  return error;
}

}  // namespace sidestep
