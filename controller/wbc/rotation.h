// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// rotation: between rotations and rotation vectors (axis times angle, rad).

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sidestep::wbc {

/// Rotation vector in W that turns `from` into `to`, both R_W.
inline Eigen::Vector3d RotationError_W(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::AngleAxisd error(to * from.transpose());
  return error.angle() * error.axis();
}

/// The rotation of a rotation vector.
inline Eigen::Quaterniond FromRotationVector(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle < 1e-12) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace sidestep::wbc
