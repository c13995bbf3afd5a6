// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// make_solver: the only place that knows which back ends there are.

#include <memory>

#include "controller/mpc/problem/centroidal_solver.h"
#include "controller/types/mpc_params.h"

namespace sidestep::mpc {

/// Makes the back end. Throws ContractViolation for a value that no MpcBackend has.
std::unique_ptr<CentroidalSolver> MakeSolver(MpcBackend backend, const SolverOptions& options);

}  // namespace sidestep::mpc
