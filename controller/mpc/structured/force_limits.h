// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// force_limits: whether any contact force satisfies the friction description at all.

#include "controller/mpc/problem/centroidal_ocp.h"

namespace sidestep::mpc::structured {

/// True if some f satisfies A f <= b within `tolerance` times the size of b. The states are free
/// and the boxes are checked elsewhere, so that for a problem with an active contact this is the
/// only other way to be infeasible: any forces give a trajectory.
///
/// Minimises half the squared violation, a convex function of three numbers with piecewise
/// constant curvature, by Newton steps with a line search. Does not allocate.
bool HasFeasibleForce(const Eigen::MatrixX3d& A, const Eigen::VectorXd& b, double tolerance);

}  // namespace sidestep::mpc::structured
