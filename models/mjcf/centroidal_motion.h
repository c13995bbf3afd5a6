// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_motion: a robot's CoM and momentum, from what mj_comPos and mj_comVel leave.

#include <mujoco/mujoco.h>

#include <Eigen/Core>

namespace sidestep {

/// Of a floating tree of bodies, in W.
struct CentroidalMotion {
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};  ///< About C, N m s.
};

/// Motion of the tree whose root, a child of the world, is body `root`. `data` must have been
/// through mj_comPos and mj_comVel. The same as mj_subtreeVel's for a tenth of the work: MuJoCo
/// expresses spatial inertias and velocities at the tree's CoM, so that momenta just add up.
CentroidalMotion CentroidalMotionOf(const mjModel& model, const mjData& data, int root);

}  // namespace sidestep
