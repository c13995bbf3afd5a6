// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/make_solver.h"

#include "controller/mpc/ipopt/ipopt_solver.h"
#include "controller/mpc/structured/structured_solver.h"
#include "models/support/require.h"

namespace sidestep::mpc {

std::unique_ptr<CentroidalSolver> MakeSolver(MpcBackend backend, const SolverOptions& options) {
  if (backend == MpcBackend::kStructured) return MakeStructuredSolver(options);
  SIDESTEP_REQUIRE(backend == MpcBackend::kIpopt, static_cast<int>(backend));
  return MakeIpoptSolver(options);
}

}  // namespace sidestep::mpc
