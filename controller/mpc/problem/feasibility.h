// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// feasibility: whether anything satisfies a problem's limits.
//
// The dynamics can always be followed: any forces give a trajectory. Only limits that contradict
// each other make a problem infeasible: a foot's box without inside, or friction rows that no force
// keeps.

#include <string>

#include "controller/mpc/problem/centroidal_ocp.h"

namespace sidestep::mpc {

/// How far the force that does best stays from satisfying A f <= b: its largest violation (N), rows
/// scaled to unit length; not above `enough` counts as done.
///
/// Minimises half the squared violation, a convex function of three numbers with piecewise
/// constant curvature, by Newton steps with a line search. Does not allocate.
double LeastForceViolation(const Eigen::MatrixX3d& A, const Eigen::VectorXd& b, double enough);

/// True if some f satisfies A f <= b within `tolerance` times the size of b.
bool HasFeasibleForce(const Eigen::MatrixX3d& A, const Eigen::VectorXd& b, double tolerance);

/// True if no point satisfies the problem's limits: a box is empty or, where a contact is active,
/// the friction rows contradict each other by more than a billionth of their size. Does not
/// allocate.
bool IsInfeasible(const CentroidalOcp& ocp);

/// Why, in a few words, with the misses in SI units. Empty if it isn't infeasible.
std::string Infeasibility(const CentroidalOcp& ocp);

}  // namespace sidestep::mpc
