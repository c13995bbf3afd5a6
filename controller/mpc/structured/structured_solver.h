// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// structured_solver: the back end that exploits the stages of the problem.

#include <memory>

#include "controller/mpc/problem/centroidal_solver.h"

namespace sidestep::mpc {

/// Makes the back end "structured": a primal-dual interior point method whose Newton systems are
/// eliminated stage by stage.
///
/// Memory grows to the largest horizon, contacts and vertices met; solves of problems no larger,
/// whatever their schedule, do not allocate. Deterministic on one machine; processors with AVX2
/// and others differ in the last bits.
std::unique_ptr<CentroidalSolver> MakeStructuredSolver(const SolverOptions& options);

}  // namespace sidestep::mpc
