// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// momentum: linear and angular momentum of a robot, from what mj_comPos and mj_comVel leave.

#include <mujoco/mujoco.h>

#include <Eigen/Core>

namespace sidestep {

/// Of a floating tree of bodies, in W.
struct Momentum {
  Eigen::Vector3d linear{Eigen::Vector3d::Zero()};   ///< N s.
  Eigen::Vector3d angular{Eigen::Vector3d::Zero()};  ///< About the tree's CoM, N m s.
};

/// Momentum of the tree whose root, a child of the world, is body `root`. `data` must have been
/// through mj_comPos and mj_comVel. The same as mj_subtreeVel's for a tenth of the work: MuJoCo
/// expresses spatial inertias and velocities at the tree's CoM, so that momenta just add up.
Momentum MomentumOf(const mjModel& model, const mjData& data, int root);

}  // namespace sidestep
