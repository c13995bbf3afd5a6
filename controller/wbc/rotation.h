// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// rotation: between rotations and rotation vectors (axis times angle, rad).

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sidestep::wbc {

/// Rotation vector in W that turns `from` into `to`, both R_W.
/// The shorter way round: its length is in [0, pi]. Divided by a time it is the angular velocity,
/// in W, that removes the error in that time.
inline Eigen::Vector3d RotationError_W(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::AngleAxisd error(to * from.transpose());
  return error.angle() * error.axis();
}

/// The rotation of a rotation vector.
/// The exponential map; below 1e-12 rad it is the identity, where the axis has no digits left.
inline Eigen::Quaterniond FromRotationVector(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle < 1e-12) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace sidestep::wbc
