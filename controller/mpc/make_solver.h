// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// make_solver: the only place that knows which back ends there are.

#include <memory>
#include <string>

#include "controller/mpc/problem/centroidal_solver.h"

namespace sidestep::mpc {

/// Makes the back end called `name`: "ipopt" or "structured". Throws ContractViolation for any
/// other name.
std::unique_ptr<CentroidalSolver> MakeSolver(const std::string& name, const SolverOptions& options);

}  // namespace sidestep::mpc
