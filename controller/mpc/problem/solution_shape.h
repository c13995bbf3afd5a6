// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// solution_shape: an MpcSolution as a point of one CentroidalOcp: its shapes, and where to start.

#include <Eigen/Core>

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"

namespace sidestep::mpc {

/// Gives the trajectories of `solution` the shapes of `ocp`, all zero, phases at their given or
/// nominal places. Does not allocate if they had them already.
void ResetToShape(const CentroidalOcp& ocp, MpcSolution* solution);

/// True if the trajectories of `solution` have the shapes of `ocp`.
bool HasShape(const CentroidalOcp& ocp, const MpcSolution& solution);

/// True if every number of the trajectories is finite.
bool IsFinite(const MpcSolution& solution);

/// The weight's share of one vertex at knot k: -m g / (number of active vertices), N; zero in
/// flight. A force of zero is the friction cone's apex, where an interior point method starts
/// badly; this is a point inside.
Eigen::Vector3d WeightShare(const CentroidalOcp& ocp, int k);

/// The starting point without a guess: the CoM at its reference, feet at their nominal places,
/// forces sharing the weight, momenta zero.
void ColdStart(const CentroidalOcp& ocp, MpcSolution* guess);

}  // namespace sidestep::mpc
