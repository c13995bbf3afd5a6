// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nlp_points: between points of the NLP (mass-normalised, flat) and MpcSolution (SI, named).

#include <Eigen/Core>

#include "controller/mpc/centroidal_ocp.h"
#include "controller/mpc/mpc_solution.h"
#include "controller/mpc/nlp_layout.h"

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

/// x of `point`. Does not allocate if x has the right size.
void PackPoint(const CentroidalOcp& ocp, const NlpLayout& layout, const MpcSolution& point,
               Eigen::VectorXd* x);

/// The trajectories of x, state 0 and fixed phases included; other fields are left alone.
void UnpackPoint(const CentroidalOcp& ocp, const NlpLayout& layout,
                 const Eigen::Ref<const Eigen::VectorXd>& x, MpcSolution* point);

}  // namespace sidestep::mpc
