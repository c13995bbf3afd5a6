// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/momentum_reference.h"

#include <cmath>

#include "controller/model/upright.h"

namespace sidestep {

Eigen::Vector3d LevellingMomentum(const Eigen::Quaterniond& q_WB, const Eigen::Matrix3d& inertia_B,
                                  double rate_radps) {
  Eigen::Vector3d momentum = q_WB * (inertia_B * (rate_radps * UprightError_B(q_WB)));
  momentum.z() = 0.0;
  return momentum;
}

Eigen::Vector3d MomentumReference(const Eigen::Vector3d& momentum, double rate_radps,
                                  double time_s) {
  return std::exp(-rate_radps * time_s) * momentum;
}

}  // namespace sidestep
