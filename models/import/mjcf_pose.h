// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_pose: a pose from MuJoCo's numbers.

#include <Eigen/Geometry>

#include "models/mjcf/quaternion.h"

namespace sidestep::importer {

/// @param pos   3 numbers (m); null: none.
/// @param quat  4 numbers, w first.
inline Eigen::Isometry3d PoseOf(const mjtNum* pos, const mjtNum* quat) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = FromMuJoCo(quat).normalized().toRotationMatrix();
  if (pos != nullptr) X.translation() = Eigen::Map<const Eigen::Vector3d>(pos);
  return X;
}

}  // namespace sidestep::importer
