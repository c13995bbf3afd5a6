// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/com_spline.h"

#include "controller/types/quintic.h"

namespace sidestep {

ComReference QuinticAt(const ComReference& from, const ComReference& to, double duration_s,
                       double time_s) {
  if (time_s < 0.0) return {from.p_WC, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  if (time_s > duration_s) return {to.p_WC, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  ComReference at;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const QuinticState state = Quintic({from.p_WC[axis], from.v_WC[axis], from.a_WC[axis]},
                                       {to.p_WC[axis], to.v_WC[axis], to.a_WC[axis]}, duration_s)
                                   .At(time_s);
    at.p_WC[axis] = state.position;
    at.v_WC[axis] = state.velocity;
    at.a_WC[axis] = state.acceleration;
  }
  return at;
}

}  // namespace sidestep
