// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nlp_points: between points of the NLP (mass-normalised, flat) and MpcSolution (SI, named).

#include <Eigen/Core>

#include "controller/mpc/ipopt/nlp_layout.h"
#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"

namespace sidestep::mpc {

/// x of `point`. Does not allocate if x has the right size.
void PackPoint(const CentroidalOcp& ocp, const NlpLayout& layout, const MpcSolution& point,
               Eigen::VectorXd* x);

/// The trajectories of x, state 0 and fixed phases included; other fields are left alone.
void UnpackPoint(const CentroidalOcp& ocp, const NlpLayout& layout,
                 const Eigen::Ref<const Eigen::VectorXd>& x, MpcSolution* point);

}  // namespace sidestep::mpc
