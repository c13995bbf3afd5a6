// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// solver_setup: how a problem was solved, kept beside it, so that it can be solved alike again.
//
// In a problem's file under `solver`: backend (a name of MpcBackend), tolerance, max_iterations
// and, unless the solve began cold, guess: com_m, linear_momentum, angular_momentum and contacts as
// in a solution.

#include <nlohmann/json.hpp>
#include <optional>

#include "controller/mpc/problem/centroidal_solver.h"
#include "controller/types/mpc_params.h"

namespace sidestep::mpc {

/// With what a problem was solved, within which limits and from where.
struct SolverSetup {
  MpcBackend backend{MpcBackend::kIpopt};
  SolverOptions options;
  std::optional<MpcSolution> guess;  ///< None: a cold start.
};

/// Throws ContractViolation if the guess's shapes differ from the problem's.
nlohmann::json SolverSetupToJson(const CentroidalOcp& ocp, const SolverSetup& setup);

/// Reads the block of `ocp`. Throws ConfigError as OcpFromJson(), its paths beginning with
/// $.solver.
SolverSetup SolverSetupFromJson(const CentroidalOcp& ocp, const nlohmann::json& block);

}  // namespace sidestep::mpc
