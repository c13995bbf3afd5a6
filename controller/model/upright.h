// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// upright: how far a base leans, as a rotation.

#include <Eigen/Geometry>
#include <cmath>

namespace sidestep {

/// Rotation vector (rad, in B) that turns the base upright and keeps its heading. At 180 degrees
/// the axis is not defined; the error is then zero, and the robot lies on its back anyway.
inline Eigen::Vector3d UprightError_B(const Eigen::Quaterniond& q_WB) {
  const Eigen::Vector3d up_B = q_WB.conjugate() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ().cross(up_B);
  const double sine = axis.norm();
  if (sine < 1e-9) return Eigen::Vector3d::Zero();
  return axis * (std::atan2(sine, up_B.z()) / sine);
}

}  // namespace sidestep
