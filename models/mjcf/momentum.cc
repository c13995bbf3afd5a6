// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/momentum.h"

#include <Eigen/Geometry>

namespace sidestep {

Momentum MomentumOf(const mjModel& model, const mjData& data, int root) {
  using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
  Momentum total;
  for (int body = root; body < model.nbody; ++body) {
    if (model.body_rootid[body] != root) continue;
    const mjtNum* inertia = data.cinert + 10 * body;  // xx yy zz xy xz yz, m (c - p_WC), m
    const ConstVector3Map first_moment(inertia + 6);
    const ConstVector3Map w(data.cvel + 6 * body);
    const ConstVector3Map v(data.cvel + 6 * body + 3);
    Eigen::Matrix3d I;
    I << inertia[0], inertia[3], inertia[4],  //
        inertia[3], inertia[1], inertia[5],   //
        inertia[4], inertia[5], inertia[2];
    total.angular += I * w + first_moment.cross(v);
    total.linear += inertia[9] * v - first_moment.cross(w);
  }
  return total;
}

}  // namespace sidestep
