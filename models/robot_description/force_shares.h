// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// force_shares: how a foot's force must be shared between its vertices for its centre of pressure
// to lie at a given point.

#include <Eigen/Core>

namespace sidestep {

/// The shares s (n_v) nearest to equal ones with sum_j s_j = 1 and sum_j s_j c_j = cop, in x and y:
/// s = A^T (A A^T)^-1 [1, cop] with A = [1; c_x; c_y], the solution of least norm.
///
/// @param vertices_m  3 x n_v: c_j in the foot's frame F, n_v >= 1; z is not used.
/// @param cop_m       The point, in F.
/// @return            Of the size n_v. Empty if no shares have that centre of pressure, or if these
///                    have a negative one: the point lies outside the vertices' hull, or near its
///                    border (for a rectangle, outside the diamond between its sides' middles).
Eigen::VectorXd ForceShares(const Eigen::Matrix3Xd& vertices_m, const Eigen::Vector2d& cop_m);

}  // namespace sidestep
