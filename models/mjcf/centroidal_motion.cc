// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/centroidal_motion.h"

#include <Eigen/Geometry>

namespace sidestep {

CentroidalMotion CentroidalMotionOf(const mjModel& model, const mjData& data, int root) {
  using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
  CentroidalMotion motion;
  motion.p_WC = ConstVector3Map(data.subtree_com + 3 * root);
  Eigen::Vector3d linear_momentum = Eigen::Vector3d::Zero();
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
    motion.angular_momentum += I * w + first_moment.cross(v);
    linear_momentum += inertia[9] * v - first_moment.cross(w);
  }
  motion.v_WC = linear_momentum / model.body_subtreemass[root];
  return motion;
}

}  // namespace sidestep
