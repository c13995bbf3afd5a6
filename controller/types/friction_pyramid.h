// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// friction_pyramid: the one description of which contact forces do not slip, for the MPC, for
// whole-body control and for the verdict.
//
// The pyramid |fx| + |fy| <= mu fz, with z the ground's normal. It lies inside Coulomb's circular
// cone and touches it along the axes x and y, so that a force that keeps it does not slip.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace sidestep {

/// The pyramid as rows of A f <= 0, a row a face, for forces in axes whose z is the ground's normal
/// (a foot's F, or W on a level floor). No row is scaled: the first two columns are +-1.
inline Eigen::Matrix<double, 4, 3> FrictionPyramid(double friction) {
  Eigen::Matrix<double, 4, 3> A;
  A << 1, 1, -friction, -1, 1, -friction, -1, -1, -friction, 1, -1, -friction;
  return A;
}

/// By how much f_F (N) violates the pyramid, N: the excess of |fx| + |fy| over what mu fz allows,
/// or the pull on the ground if that is more; 0 inside.
inline double FrictionViolation_N(const Eigen::Vector3d& f_F, double friction) {
  const double tangential_N = std::abs(f_F.x()) + std::abs(f_F.y());
  return std::max({0.0, tangential_N - friction * f_F.z(), -f_F.z()});
}

}  // namespace sidestep
