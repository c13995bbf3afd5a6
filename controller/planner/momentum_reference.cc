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

void FillMomentumReference(const Eigen::Vector3d& momentum, double rate_radps, double step_s,
                           Eigen::Matrix3Xd* reference) {
  for (Eigen::Index k = 0; k < reference->cols(); ++k) {
    reference->col(k) = std::exp(-rate_radps * static_cast<int>(k) * step_s) * momentum;
  }
}

}  // namespace sidestep
